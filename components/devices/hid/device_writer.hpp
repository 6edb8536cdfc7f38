// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "components/devices/hid/device_exchange.hpp"
#include "framework/time_source.hpp"

namespace trocar::hid {

/// What the writing thread of a driver does: sends each command of the loop once, and a safe one
/// when the loop hangs.
///
/// When the supervisor gives the loop up, hold is sent once more without effort. What the loop
/// posts afterwards of a tick that had begun before is not sent.
class DeviceWriter {
 public:
  DeviceWriter(TimeSource& time, DeviceExchange& exchange) : time_(time), exchange_(exchange) {}

  /// Sends what is new. @return whether there was something
  bool serve();

 private:
  bool send_safe(std::int64_t stalled_ns);
  void send(const PostedCommand& posted);

  TimeSource& time_;
  DeviceExchange& exchange_;
  std::unique_ptr<Link> out_;
  PostedCommand last_{};
  WrittenCommand written_{};
  std::uint16_t sequence_ = 0;
  std::int64_t stalled_ns_ = 0;  // seen
};

/// A command with hold alone, from one that was computed before.
PostedCommand safe_command(const PostedCommand& last, std::int64_t now_ns) RT_SAFE;

}  // namespace trocar::hid
