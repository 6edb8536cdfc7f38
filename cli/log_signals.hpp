// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "framework/recording/ros2_schema.hpp"

namespace trocar::cli {

/// A number in the messages of a channel.
struct LogSignal {
  std::string name{};       // "wall.force.z"
  std::string unit{};       // "N"; "" where the schema names none
  std::string port{};       // "wall.force": the value that it is a part of
  bool is_text = false;     // has no values
  std::uint64_t count = 0;  // of values that were read
  double first = std::numeric_limits<double>::quiet_NaN();
  double last = std::numeric_limits<double>::quiet_NaN();
  double min = std::numeric_limits<double>::quiet_NaN();  // NaN values apart
  double max = std::numeric_limits<double>::quiet_NaN();

  void add(double value);
};

/// The signals of a schema in the order of the bytes, strings included. Units stand at the
/// beginning of a field's comment, "[N] …" or one for each block, "[N, N m] …", and hold for what
/// is inside.
std::vector<LogSignal> signals_of(const std::vector<Ros2Message>& messages);

/// Whether `pattern` means the signal: with `*` and `?` the whole name, otherwise a part of it.
bool matches(std::string_view pattern, const std::string& name);

}  // namespace trocar::cli
