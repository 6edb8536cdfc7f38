// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "framework/recording/ros2_decode.hpp"
#include "framework/stream/server_message.hpp"

namespace trocar::gui {

/// A number of a run as the stream's preview tells it: the extremes and the last within a thirtieth
/// of a second, or since somebody looked.
struct WatchedSignal {
  std::string name;
  std::string unit;
  double min = 0.0, max = 0.0, last = 0.0;
  std::size_t offset = 0;  // [B] of its band in the message
};

/// A thread's numbers, from its "trocar/Preview" messages.
class WatchedThread {
 public:
  /// @throw std::invalid_argument when the channel has another schema
  explicit WatchedThread(const stream::Channel& channel);

  const std::string& name() const { return name_; }
  const std::vector<WatchedSignal>& signal_list() const { return signals_; }
  std::uint32_t channel() const { return channel_; }
  bool has_values() const { return has_values_; }

  /// @throw std::runtime_error when the message has another size than its schema says
  void take(std::span<const std::byte> message);
  /// Extremes are from now on those since now.
  void begin_interval() { fresh_ = true; }

  std::int64_t tick() const;
  double time() const;            // [s] of the newest row
  double rate() const;            // [Hz] of ticks over the last seconds; 0: not known
  double worst_lateness() const;  // [s] since the interval began
  bool fault_latched() const { return (flags() & 1) != 0; }
  bool rendering() const { return (flags() & 2) != 0; }

 private:
  const WatchedSignal* find(std::string_view name) const;
  double last(std::string_view name) const;
  std::int64_t flags() const;

  std::string name_;
  std::uint32_t channel_;
  std::size_t size_ = 0;  // [B] of a message
  std::vector<WatchedSignal> signals_;
  bool has_values_ = false, fresh_ = true;
  double from_time_ = 0.0, from_tick_ = 0.0;  // where the rate is measured from
};

}  // namespace trocar::gui
