// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "framework/recording/ros2_schema.hpp"

namespace trocar {

/// A primitive of a message, as people call it.
struct SchemaSignal {
  std::string name{};    // "wall.force.z"
  std::string unit{};    // "N"; "" where the schema names none
  std::string port{};    // "wall.force": the value that it is a part of
  bool is_text = false;  // not a number
};

/// The signals of a schema in the order of the bytes, strings included, as `Ros2Decoder::leaves()`
/// are. Units stand at the beginning of a field's comment, "[N] …" or one for each block,
/// "[N, N m] …", and hold for what is inside.
std::vector<SchemaSignal> signals_of(const std::vector<Ros2Message>& messages);

/// Whether `pattern` means the signal: with `*` and `?` the whole name, otherwise a part of it.
bool matches(std::string_view pattern, const std::string& name);

}  // namespace trocar
