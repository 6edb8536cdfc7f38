// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trocar {

enum class Ros2Type : std::uint8_t {
  boolean,
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64,
  string,
};

struct Ros2TypeName {
  std::string_view name;
  Ros2Type type;
  std::size_t size;  // [B], 0: varies
};

inline constexpr std::array<Ros2TypeName, 12> ros2_types = {{
    {"bool", Ros2Type::boolean, 1},
    {"int8", Ros2Type::int8, 1},
    {"uint8", Ros2Type::uint8, 1},
    {"int16", Ros2Type::int16, 2},
    {"uint16", Ros2Type::uint16, 2},
    {"int32", Ros2Type::int32, 4},
    {"uint32", Ros2Type::uint32, 4},
    {"int64", Ros2Type::int64, 8},
    {"uint64", Ros2Type::uint64, 8},
    {"float32", Ros2Type::float32, 4},
    {"float64", Ros2Type::float64, 8},
    {"string", Ros2Type::string, 0},
}};

/// The primitive type of that name, or null.
const Ros2TypeName* find_ros2_type(std::string_view name);

struct Ros2Field {
  std::string name;
  std::string type;                // a primitive's name, or "package/Name" of another message
  std::uint32_t array_length = 0;  // 0: no array
  std::string comment = {};        // unit and documentation, one line
  bool operator==(const Ros2Field&) const = default;
};

struct Ros2Message {
  std::string name;  // "package/Name"
  std::vector<Ros2Field> fields;
  std::string comment = {};  // one line
  bool operator==(const Ros2Message&) const = default;
};

/// The text of a `ros2msg` schema: the first message's fields, then each other
/// definition behind a line of 80 '=' and its name
/// (https://mcap.dev/spec/registry, design.ros2.org/articles/legacy_interface_definition).
/// @throw std::invalid_argument for a name that ROS 2 does not allow, a type that is not
///        defined, a name that stands twice, a message without fields or inside itself.
std::string ros2_schema_text(const std::vector<Ros2Message>& messages);

/// The reverse. Constants and default values take no bytes and are left out.
/// @param name of the first message, "package/Name" or "package/msg/Name"
/// @throw std::invalid_argument with the line, also for arrays whose length varies.
std::vector<Ros2Message> parse_ros2_schema(std::string_view name, std::string_view text);

/// `name` with ROS 2's second form "package/msg/Name" brought to "package/Name".
std::string ros2_short_name(std::string_view name);

/// @throw std::invalid_argument as ros2_schema_text() does.
void check_ros2_messages(const std::vector<Ros2Message>& messages);

}  // namespace trocar
