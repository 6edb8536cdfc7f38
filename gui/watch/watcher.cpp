// SPDX-License-Identifier: Apache-2.0
#include "gui/watch/watcher.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trocar::gui {
namespace {

constexpr int redraw_interval_ms = 20;
constexpr double first_contact_s = 5.0;  // until --list and --stop give up
constexpr std::size_t remarks_kept = 100;

}  // namespace

Watcher::Watcher(WatchOptions options, Print print, Print complain)
    : options_(std::move(options)), print_(std::move(print)), complain_(std::move(complain)) {
  connect(&client_, &StreamClient::channels_changed, this, &Watcher::follow_channels);
  connect(&client_, &StreamClient::state_changed, this, &Watcher::tell_link);
  connect(&client_, &StreamClient::services_changed, this, [this] {
    if (options_.stop && !stop_.asked()) stop();
  });
  connect(&client_, &StreamClient::message, this,
          [this](const stream::Channel& channel, quint64, std::span<const std::byte> bytes) {
            take(channel, bytes);
          });
  connect(&client_, &StreamClient::status, this, [this](const stream::Status& status) {
    if (is_json())
      tell({{"type", "status"}, {"level", static_cast<int>(status.level)}, {"text", status.text}});
    else
      remark(status.text);
  });
  connect(&look_, &QTimer::timeout, this, &Watcher::look);
  connect(&tell_, &QTimer::timeout, this, &Watcher::tell_values);
}

void Watcher::open(const QUrl& url) {
  clock_.start();
  client_.open(url);
  look_.start(redraw_interval_ms);
  if (!options_.list && !options_.stop) tell_.start(static_cast<int>(1000.0 * options_.interval));
}

void Watcher::key(char which) {
  if (which == ' ') stop();
  if (which == 'q' || which == 3) Q_EMIT done(0);
  if (which == 'a')
    client_.call("acknowledge", nlohmann::json::object(),
                 [this](const nlohmann::json&, const std::string& trouble) {
                   remark(trouble.empty() ? "acknowledging" : trouble);
                 });
}

WatchView Watcher::view() const {
  WatchView view{.url = client_.url().toString(QUrl::RemoveQuery).toStdString(),
                 .link = client_.state(),
                 .why = client_.why(),
                 .round_trip_ms = client_.round_trip_ms(),
                 .state = state_,
                 .threads = {},
                 .patterns = options_.patterns,
                 .remarks = remarks_};
  for (const std::unique_ptr<WatchedThread>& thread : threads_)
    view.threads.push_back(thread.get());
  return view;
}

void Watcher::follow_channels() {
  std::erase_if(threads_,
                [this](const auto& one) { return client_.channels().count(one->channel()) == 0; });
  std::erase_if(subscribed_,
                [this](std::uint32_t id) { return client_.channels().count(id) == 0; });
  for (const auto& [id, channel] : client_.channels()) {
    if (std::find(subscribed_.begin(), subscribed_.end(), id) != subscribed_.end()) continue;
    if (channel.schema_name == "trocar/Preview")
      threads_.push_back(std::make_unique<WatchedThread>(channel));
    else if (channel.topic != "/events" && channel.topic != "/trocar/state")
      continue;
    subscribed_.push_back(id);
    client_.subscribe(id);
  }
}

void Watcher::take(const stream::Channel& channel, std::span<const std::byte> bytes) {
  if (channel.topic == "/events") return take_event(bytes);
  if (channel.topic == "/trocar/state") return take_state(bytes);
  for (const std::unique_ptr<WatchedThread>& thread : threads_) {
    if (thread->channel() != channel.id) continue;
    thread->take(bytes);
    stop_.saw(now_s(), thread->tick(), thread->rendering());
  }
}

void Watcher::take_event(std::span<const std::byte> bytes) {
  const RunEvent event = read_event(bytes);
  if (is_json())
    tell(event_json(event));
  else if (!options_.list && !options_.stop)
    remark(event_text(event));
}

void Watcher::take_state(std::span<const std::byte> bytes) {
  const std::optional<StreamState> state = read_state(bytes);
  if (!state) return;
  const bool another = state->run != state_.run || state->running != state_.running;
  state_ = *state;
  if (!state_.running) stop_.saw_end(now_s());
  if (is_json() && another)
    tell({{"type", "state"},
          {"run", state_.run},
          {"running", state_.running},
          {"virtual_time", state_.virtual_time},
          {"log", state_.log},
          {"recording", state_.recording.file},
          {"rows", state_.recording.rows},
          {"missed", state_.recording.missed}});
}

void Watcher::tell_link() {
  if (client_.state() == link_told_) return;
  link_told_ = client_.state();
  was_open_ = was_open_ || client_.state() == LinkState::open;
  if (is_json())
    tell({{"type", "link"}, {"state", to_string(client_.state())}, {"why", client_.why()}});
  else if (client_.state() != LinkState::open && was_open_)
    remark(fmt::format("{}: {}", to_string(client_.state()), client_.why()));
}

void Watcher::tell_values() {
  if (is_json()) {
    for (const std::unique_ptr<WatchedThread>& thread : threads_)
      if (thread->has_values()) tell(values_json(*thread, options_.patterns));
  } else if (options_.form == WatchOptions::Form::lines) {
    const WatchView now = view();
    print_(headline(now));
    if (!options_.patterns.empty())
      for (const std::string& line : signal_lines(now)) print_("  " + line);
  }
  Q_EMIT changed();
  for (const std::unique_ptr<WatchedThread>& thread : threads_) thread->begin_interval();
}

void Watcher::look() {
  const double now = now_s();
  if (stop_.asked() && !stop_told_ && (stop_.confirmed_after() || stop_.overdue(now))) {
    stop_told_ = true;
    if (is_json())
      tell({{"type", "stop"},
            {"confirmed", stop_.confirmed_after().has_value()},
            {"after", stop_.confirmed_after().value_or(0.0)}});
    else
      (options_.stop ? print_ : [this](const std::string& text) { remark(text); })(stop_.text(now));
    if (options_.stop) return Q_EMIT done(stop_.confirmed_after() ? 0 : 1);
  }
  if (options_.list && std::any_of(threads_.begin(), threads_.end(),
                                   [](const auto& one) { return one->has_values(); })) {
    if (is_json())
      tell_values();
    else
      for (const std::string& line : signal_lines(view())) print_(line);
    return Q_EMIT done(0);
  }
  if ((options_.list || (options_.stop && !stop_.asked())) && now > first_contact_s) {
    complain_(client_.state() == LinkState::open
                  ? "there is no run whose signals could be listed"
                  : "nobody answers at " + view().url + ": " + client_.why());
    return Q_EMIT done(1);
  }
  if (options_.seconds > 0 && now > options_.seconds) {
    const bool met = client_.state() == LinkState::open;
    if (!met) complain_("nobody answers at " + view().url + ": " + client_.why());
    Q_EMIT done(met ? 0 : 1);
  }
}

void Watcher::stop() {
  stop_.ask(now_s());
  stop_told_ = false;
  client_.call("stop", nlohmann::json::object(),
               [this](const nlohmann::json&, const std::string& trouble) {
                 if (!trouble.empty()) return remark("stop: " + trouble);
                 std::int64_t tick = -1;
                 for (const std::unique_ptr<WatchedThread>& thread : threads_)
                   if (thread->has_values()) tick = std::max(tick, thread->tick());
                 stop_.accepted(tick);
               });
}

void Watcher::remark(const std::string& text) {
  if (options_.form == WatchOptions::Form::screen) {
    remarks_.push_back(text);
    if (remarks_.size() > remarks_kept) remarks_.erase(remarks_.begin());
    Q_EMIT changed();
  } else {
    (is_json() ? complain_ : print_)(text);
  }
}

void Watcher::tell(const nlohmann::ordered_json& json) {
  print_(json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

}  // namespace trocar::gui
