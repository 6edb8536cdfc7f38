// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "components/devices/hid/input_reader.hpp"
#include "framework/realtime/service_thread.hpp"

namespace trocar::hid {

/// The loop's end of the way from an input device. With a thread nothing here waits, and the loop
/// neither locks nor allocates.
class InputLine {
 public:
  /// @param time outlives it, as does `layout`
  /// @param thread without, the loop's end reads, and nothing waits: for tests
  InputLine(std::unique_ptr<LinkSource> source, TimeSource& time, const DeviceLayout& layout,
            bool thread = true)
      : source_(std::move(source)),
        time_(time),
        thread_(thread),
        reader_(*source_, time, layout, slot_) {}

  /// Looks for the device. @throw std::runtime_error as LinkSource
  void open() { reader_.open(); }
  /// Reads from now on.
  void start(const std::string& name);

  /// The newest that is known.
  void load(InputSnapshot& snapshot) RT_SAFE;
  std::int64_t now() const RT_SAFE { return time_.now(); }

 private:
  std::unique_ptr<LinkSource> source_;
  TimeSource& time_;
  bool thread_;
  Latest<InputSnapshot> slot_;
  InputReader reader_;
  std::optional<ServiceThread> reading_;
};

}  // namespace trocar::hid
