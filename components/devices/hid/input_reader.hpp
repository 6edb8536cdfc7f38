// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "components/devices/hid/input_snapshot.hpp"
#include "components/devices/hid/link.hpp"
#include "framework/realtime/latest.hpp"
#include "framework/time_source.hpp"

namespace trocar::hid {

/// What the thread of an input device does: takes its reports, and looks for the device each second
/// while it is not there.
class InputReader {
 public:
  /// All outlive it.
  InputReader(LinkSource& source, TimeSource& time, const DeviceLayout& layout,
              Latest<InputSnapshot>& to);

  /// Looks for the device. @throw std::runtime_error as LinkSource
  void open();
  /// Takes one report, or looks for a device that is gone. @return false when there was nothing
  /// @param timeout_ms 0: does not wait
  bool serve(int timeout_ms);

 private:
  bool reopen(int timeout_ms);

  LinkSource& source_;
  TimeSource& time_;
  const DeviceLayout& layout_;
  Latest<InputSnapshot>& to_;
  std::unique_ptr<Link> in_;
  std::vector<std::uint8_t> bytes_;
  InputSnapshot snapshot_;
  std::int64_t try_again_ns_ = 0;
};

}  // namespace trocar::hid
