// SPDX-License-Identifier: Apache-2.0
#include "cli/log_summary.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include "framework/recording/mcap_reader.hpp"
#include "framework/recording/ros2_decode.hpp"
#include "framework/recording/row_layout.hpp"

namespace trocar::cli {
namespace {

using Json = nlohmann::ordered_json;

std::int64_t as_integer(const Ros2Value& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value)) return *number;
  return 0;
}

/// What a published row says; text that is no JSON stays text.
Json json_of(std::string_view text) {
  constexpr int deepest = 64;  // printing it recurses
  const auto not_too_deep = [](int depth, Json::parse_event_t, Json&) { return depth < deepest; };
  Json json = Json::parse(text.begin(), text.end(), not_too_deep, false);
  return json.is_discarded() ? Json(std::string(text)) : json;
}

/// Goes through a log's messages, one object for each channel.
class ChannelReader {
 public:
  ChannelReader(LogSummary::Channel& channel, const McapSchema* schema, bool values)
      : channel_(channel) {
    if (schema == nullptr || schema->encoding != "ros2msg" || channel.encoding != "cdr") {
      channel.problem = std::string("only counted: ") + (schema == nullptr ? "it has no schema"
                                                         : schema->encoding != "ros2msg"
                                                             ? "its schema is not ros2msg"
                                                             : "its messages are not cdr");
      return;
    }
    try {
      decoder_ = std::make_unique<Ros2Decoder>(schema->name, schema->data);
      for (SchemaSignal& signal : signals_of(parse_ros2_schema(schema->name, schema->data)))
        channel.signal_list.push_back({std::move(signal)});
    } catch (const std::invalid_argument& error) {
      channel.problem = std::string("only counted: ") + error.what();
      return;
    }
    const std::string name = ros2_short_name(schema->name);
    channel.decoded = true;
    channel.rows = name == "trocar/Row" && has({"tick", "time", "flags"});
    is_events_ = name == "trocar/Event" && has({"tick", "time", "kind", "source", "detail"});
    is_published_ = channel.topic == "/published" && has({"name", "json"});
    values_ = values;
  }

  void read(const McapMessage& message, LogSummary& log) {
    channel_.first_ns =
        counted_ == 0 ? message.log_time_ns : std::min(channel_.first_ns, message.log_time_ns);
    channel_.last_ns = std::max(channel_.last_ns, message.log_time_ns);
    ++counted_;
    if (!channel_.decoded || channel_.damaged) return;
    try {
      decode(message, log);
    } catch (const std::runtime_error& error) {
      channel_.damaged = true;
      channel_.problem = "message " + std::to_string(counted_) + ": " + error.what();
    }
  }

 private:
  bool has(std::initializer_list<const char*> leaves) const {
    return std::all_of(leaves.begin(), leaves.end(),
                       [&](const char* leaf) { return decoder_->find(leaf) != nullptr; });
  }

  void decode(const McapMessage& message, LogSummary& log) {
    if (channel_.rows) add_row(message);
    if (is_events_) add_event(message, log);
    if (is_published_) add_published(message, log);
    if (!values_) return;
    std::size_t i = 0;
    decoder_->visit(message.payload, [&](const Ros2Leaf&, const Ros2Value& value) {
      channel_.signal_list[i++].add(as_double(value));
    });
  }

  void add_row(const McapMessage& message) {
    const auto integer = [&](const char* name) {
      return as_integer(decoder_->value(message.payload, *decoder_->find(name)));
    };
    channel_.ticks.add(integer("tick"), integer("time"),
                       (integer("flags") & RowHeader::slots_skipped) != 0);
  }

  void add_event(const McapMessage& message, LogSummary& log) {
    LogSummary::Event event;
    decoder_->visit(message.payload, [&](const Ros2Leaf& leaf, const Ros2Value& value) {
      const auto* text = std::get_if<std::string_view>(&value);
      if (leaf.path == "tick") event.tick = as_integer(value);
      if (leaf.path == "time") event.time_ns = as_integer(value);
      if (leaf.path == "value") event.value = as_double(value);
      if (leaf.path == "limit") event.limit = as_double(value);
      if (text == nullptr) return;
      if (leaf.path == "thread") event.thread = *text;
      if (leaf.path == "kind") event.kind = *text;
      if (leaf.path == "source") event.source = *text;
      if (leaf.path == "detail") event.detail = *text;
    });
    log.events.push_back(std::move(event));
  }

  void add_published(const McapMessage& message, LogSummary& log) {
    std::string name;
    Json row;
    decoder_->visit(message.payload, [&](const Ros2Leaf& leaf, const Ros2Value& value) {
      const auto* text = std::get_if<std::string_view>(&value);
      if (text != nullptr && leaf.path == "name") name = *text;
      if (text != nullptr && leaf.path == "json") row = json_of(*text);
    });
    for (auto& [known, rows] : log.published)
      if (known == name) return rows.push_back(std::move(row));
    Json rows = Json::array();
    rows.push_back(std::move(row));
    log.published.emplace_back(std::move(name), std::move(rows));
  }

  LogSummary::Channel& channel_;
  std::unique_ptr<Ros2Decoder> decoder_;
  std::uint64_t counted_ = 0;
  bool is_events_ = false, is_published_ = false, values_ = false;
};

}  // namespace

double LogSummary::Channel::rate() const {
  if (rows) return ticks.rate();
  if (messages < 2 || last_ns <= first_ns) return 0.0;
  return 1e9 * static_cast<double>(messages - 1) / static_cast<double>(last_ns - first_ns);
}

bool LogSummary::damaged() const {
  return std::any_of(channels.begin(), channels.end(),
                     [](const Channel& channel) { return channel.damaged; });
}

double LogSummary::duration() const {
  double rows = 0.0;
  std::uint64_t first = UINT64_MAX, last = 0;
  for (const Channel& channel : channels) {
    if (channel.messages == 0) continue;
    first = std::min(first, channel.first_ns);
    last = std::max(last, channel.last_ns);
    if (channel.rows) rows = std::max(rows, channel.ticks.duration());
  }
  return std::max(rows, last > first ? 1e-9 * static_cast<double>(last - first) : 0.0);
}

LogSummary summarize_log(const std::string& path, bool values) {
  const McapReader reader(path);
  LogSummary log;
  log.file = path;
  log.file_size = reader.file_size();
  log.library = reader.library();
  log.problem = reader.problem();
  for (const McapAttachment& attachment : reader.attachments())
    log.attachments.push_back({attachment.name, attachment.media_type, attachment.size});
  for (const auto& [id, channel] : reader.channels()) {
    const auto schema = reader.schemas().find(channel.schema_id);
    const bool known = schema != reader.schemas().end();
    log.channels.push_back({.topic = channel.topic,
                            .schema = known ? ros2_short_name(schema->second.name) : "",
                            .encoding = channel.message_encoding,
                            .messages = reader.message_count(id)});
  }
  std::map<std::uint16_t, ChannelReader> readers;
  std::size_t i = 0;
  for (const auto& [id, channel] : reader.channels()) {
    const auto schema = reader.schemas().find(channel.schema_id);
    readers.emplace(std::piecewise_construct, std::forward_as_tuple(id),
                    std::forward_as_tuple(
                        log.channels[i++],
                        schema == reader.schemas().end() ? nullptr : &schema->second, values));
  }
  reader.messages([&](const McapMessage& message) {
    log.payload += message.payload.size();
    if (const auto found = readers.find(message.channel); found != readers.end())
      found->second.read(message, log);
  });
  return log;
}

}  // namespace trocar::cli
