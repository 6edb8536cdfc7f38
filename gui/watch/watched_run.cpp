// SPDX-License-Identifier: Apache-2.0
#include "gui/watch/watched_run.hpp"

#include <cmath>
#include <cstring>
#include <stdexcept>

#include "framework/recording/schema_signals.hpp"

namespace trocar::gui {
namespace {

constexpr std::string_view band_begin = ".min";
constexpr std::string_view preview_suffix = "/preview";

double double_at(std::span<const std::byte> message, std::size_t offset) {
  double value;
  std::memcpy(&value, message.data() + offset, sizeof value);
  return value;
}

}  // namespace

WatchedThread::WatchedThread(const stream::Channel& channel) : channel_(channel.id) {
  if (channel.schema_name != "trocar/Preview" || !channel.topic.ends_with(preview_suffix))
    throw std::invalid_argument("\"" + channel.topic + "\" is no preview");
  name_ = channel.topic.substr(1, channel.topic.size() - 1 - preview_suffix.size());
  const Ros2Decoder decoder(channel.schema_name, channel.schema);
  const std::vector<SchemaSignal> signals =
      signals_of(parse_ros2_schema(channel.schema_name, channel.schema));
  size_ = decoder.size();
  for (std::size_t i = 0; i + 2 < signals.size(); i += 3) {
    const std::string& first = signals[i].name;
    if (!first.ends_with(band_begin) || decoder.leaves()[i].type != Ros2Type::float64)
      throw std::invalid_argument("\"" + channel.topic + "\" has no bands");
    signals_.push_back({.name = first.substr(0, first.size() - band_begin.size()),
                        .unit = signals[i].unit,
                        .offset = decoder.leaves()[i].offset});
  }
}

void WatchedThread::take(std::span<const std::byte> message) {
  if (message.size() != size_)
    throw std::runtime_error("a preview of " + name_ + " has " + std::to_string(message.size()) +
                             " bytes instead of " + std::to_string(size_));
  for (WatchedSignal& signal : signals_) {
    const double min = double_at(message, signal.offset);
    const double max = double_at(message, signal.offset + 8);
    // fmin and fmax pass over NaN.
    signal.min = fresh_ ? min : std::fmin(signal.min, min);
    signal.max = fresh_ ? max : std::fmax(signal.max, max);
    signal.last = double_at(message, signal.offset + 16);
  }
  fresh_ = false;
  constexpr double seconds = 2.0;
  if (!has_values_ || time() < from_time_) {
    from_time_ = time();
    from_tick_ = last("tick");
  } else if (time() - from_time_ > 2 * seconds) {  // the newer half counts
    const double rate_now = rate();
    from_time_ = time() - seconds;
    from_tick_ = last("tick") - rate_now * seconds;
  }
  has_values_ = true;
}

const WatchedSignal* WatchedThread::find(std::string_view name) const {
  for (const WatchedSignal& signal : signals_)
    if (signal.name == name) return &signal;
  return nullptr;
}

double WatchedThread::last(std::string_view name) const {
  const WatchedSignal* signal = find(name);
  return signal == nullptr ? std::nan("") : signal->last;
}

std::int64_t WatchedThread::tick() const {
  return static_cast<std::int64_t>(last("tick"));
}

double WatchedThread::time() const {
  return last("time") / 1e9;
}

std::int64_t WatchedThread::flags() const {
  return has_values_ ? static_cast<std::int64_t>(last("flags")) : 0;
}

double WatchedThread::rate() const {
  const double passed = has_values_ ? time() - from_time_ : 0.0;
  return passed > 0.0 ? (last("tick") - from_tick_) / passed : 0.0;
}

double WatchedThread::worst_lateness() const {
  const WatchedSignal* lateness = find("lateness");
  return lateness == nullptr ? 0.0 : 1e-9 * lateness->max;
}

}  // namespace trocar::gui
