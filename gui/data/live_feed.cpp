// SPDX-License-Identifier: Apache-2.0
#include "gui/data/live_feed.hpp"

#include <algorithm>
#include <string_view>

#include "framework/stream/batch.hpp"

namespace trocar::gui {
namespace {

constexpr std::string_view batch_suffix = "/batch";

/// "/main/batch" is of the thread "main".
std::string thread_of(std::string_view topic) {
  topic.remove_prefix(1);
  return std::string(topic.substr(0, topic.size() - batch_suffix.size()));
}

bool is_batch(const stream::Channel& channel) {
  return channel.schema_name == "trocar/Batch" && channel.topic.starts_with('/') &&
         std::string_view(channel.topic).ends_with(batch_suffix);
}

}  // namespace

LiveFeed::LiveFeed(StreamClient& client, DataStore& store, Limits limits, QObject* parent)
    : QObject(parent), client_(client), store_(store), limits_(limits) {
  connect(&client_, &StreamClient::channels_changed, this, &LiveFeed::follow_channels);
  connect(&client_, &StreamClient::services_changed, this, &LiveFeed::ask_graph);
  connect(&client_, &StreamClient::message, this,
          [this](const stream::Channel& channel, quint64, std::span<const std::byte> bytes) {
            take(channel, bytes);
          });
}

bool same(const std::vector<stream::Channel>& a, const std::vector<stream::Channel>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one.id == other.id && one.topic == other.topic && one.schema == other.schema;
  });
}

/// The channels of rows are those of one run: others are another run's. After a broken connection
/// they are the same again, and what came before is kept.
void LiveFeed::follow_channels() {
  std::vector<std::uint32_t> wanted;
  std::vector<stream::Channel> batches;
  for (const auto& [id, channel] : client_.channels()) {
    if (is_batch(channel)) batches.push_back(channel);
    if (is_batch(channel) || channel.topic == "/events" || channel.topic == "/trocar/state")
      wanted.push_back(id);
  }
  for (const std::uint32_t id : wanted)
    if (std::find(subscribed_.begin(), subscribed_.end(), id) == subscribed_.end()) {
      if (client_.channels().at(id).topic == "/events") told_again_ = true;
      client_.subscribe(id);
    }
  subscribed_ = std::move(wanted);
  if (batches.empty() || same(batches, run_channels_)) return;
  run_channels_ = std::move(batches);
  begin_run();
  ask_graph();
}

void LiveFeed::begin_run() {
  std::vector<std::unique_ptr<Track>> tracks;
  for (const stream::Channel& channel : run_channels_)
    if (const auto* rows = row_channel(thread_of(channel.topic)))
      tracks.push_back(std::make_unique<Track>(thread_of(channel.topic), rows->schema_name,
                                               rows->schema, 0.0, limits_.seconds, limits_.memory));
  store_.begin_run(std::move(tracks));
}

const stream::Channel* LiveFeed::row_channel(const std::string& thread) const {
  for (const auto& [id, channel] : client_.channels())
    if (channel.topic == "/" + thread && channel.schema_name == "trocar/Row") return &channel;
  return nullptr;
}

void LiveFeed::ask_graph() {
  if (!client_.offers("graph")) return;
  client_.call("graph", nlohmann::json::object(),
               [this](const nlohmann::json& answer, const std::string& trouble) {
                 if (!trouble.empty() || answer.is_null()) return;
                 graph_ = answer;
                 Q_EMIT graph_known();
               });
  ask_parameters();
}

void LiveFeed::ask_parameters() {
  client_.watch_parameters();
  client_.call("parameters", nlohmann::json::object(),
               [this](const nlohmann::json& answer, const std::string& trouble) {
                 if (!trouble.empty() || !answer.contains("parameters")) return;
                 parameters_ = answer["parameters"];
                 Q_EMIT parameters_known();
               });
}

void LiveFeed::take(const stream::Channel& channel, std::span<const std::byte> bytes) {
  if (is_batch(channel))
    take_rows(thread_of(channel.topic), bytes);
  else if (channel.topic == "/events")
    take_event(read_event(bytes));
  else if (channel.topic == "/trocar/state")
    take_state(bytes);
}

void LiveFeed::take_event(RunEvent event) {
  if (told_again_) {
    const auto& known = store_.events();
    if (std::find(known.begin(), known.end(), event) != known.end()) return;
    told_again_ = false;
  }
  store_.add_event(std::move(event));
}

void LiveFeed::take_rows(const std::string& thread, std::span<const std::byte> bytes) {
  Track* track = store_.track(thread);
  if (track == nullptr) return;
  const auto rows = stream::Batch::rows(bytes, track->row_size());
  // Another program at the same address, with the same script.
  if (!rows.empty() && track->is_before_end(rows.front())) {
    begin_run();
    track = store_.track(thread);
  }
  for (const std::span<const std::byte> row : rows) track->add(row);
  Q_EMIT grew();
}

void LiveFeed::take_state(std::span<const std::byte> bytes) {
  const std::optional<StreamState> state = read_state(bytes);
  if (!state) return;
  state_ = *state;
  Q_EMIT state_heard();
}

}  // namespace trocar::gui
