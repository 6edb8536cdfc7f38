// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/hid/input_snapshot.hpp"

namespace trocar::hid {

/// Reports that come at given times, as if a device sent them. It is attached from the beginning;
/// it can be unplugged and plugged in again.
class PlayedReports {
 public:
  /// @param list { { at = "0 s", bytes = "01 5e 01" }, { at = "1 s", plug = "out" }, … }, bytes in
  /// hexadecimal or as a list of numbers; in any order
  /// @throw std::invalid_argument with the entry, its value and what is allowed
  explicit PlayedReports(const Literal& list);

  void begin(InputSnapshot& snapshot) RT_SAFE;
  /// All that is due.
  void play(std::int64_t time_ns, const InputLayout& layout, InputSnapshot& snapshot) RT_SAFE;

 private:
  enum class Kind { report, plug_out, plug_in };
  struct Entry {
    std::int64_t at_ns = 0;
    Kind kind = Kind::report;
    std::vector<std::uint8_t> bytes{};
  };
  static Entry entry(const Literal& value);

  std::vector<Entry> entries_;
  std::size_t next_ = 0;
};

}  // namespace trocar::hid
