// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "framework/recording/cdr.hpp"
#include "framework/recording/ros2_schema.hpp"

namespace trocar {

/// Signed and unsigned integers come as the 64-bit ones, both floats as double.
using Ros2Value = std::variant<bool, std::int64_t, std::uint64_t, double, std::string_view>;

/// `value` as a number, a bool as 0 or 1, NaN for a string.
double as_double(const Ros2Value& value);

/// One primitive of a message.
struct Ros2Leaf {
  static constexpr std::size_t varies = std::numeric_limits<std::size_t>::max();

  std::string path;  // e.g. "wall.force.z" or "device.position[2]"
  Ros2Type type{};
  std::size_t offset = varies;  // from the message's first byte [B]; varies behind a string
  std::string comment;          // of the field
};

/// Reads CDR messages by the text of their `ros2msg` schema.
class Ros2Decoder {
 public:
  using Visitor = std::function<void(const Ros2Leaf&, const Ros2Value&)>;

  /// @throw std::invalid_argument when the schema is wrong or has over 65536 primitives.
  Ros2Decoder(std::string_view schema_name, std::string_view schema_text);

  const std::vector<Ros2Leaf>& leaves() const { return leaves_; }  // in the order of the bytes
  bool is_fixed_size() const { return size_ != Ros2Leaf::varies; }
  std::size_t size() const { return size_; }  // [B] with the head, or Ros2Leaf::varies

  /// The leaf at `path`, or null.
  const Ros2Leaf* find(std::string_view path) const;

  /// Visits every primitive in order; a string is valid during the call.
  /// @throw std::runtime_error when the message is shorter or longer than the schema says.
  void visit(std::span<const std::byte> message, const Visitor& visitor) const;

  /// One value of a message. Quick where the leaf has an offset.
  /// @throw std::runtime_error as visit() does.
  Ros2Value value(std::span<const std::byte> message, const Ros2Leaf& leaf) const;

 private:
  void expand(const Ros2Message& message, const std::string& prefix);
  void expand_field(const Ros2Field& field, const std::string& path);
  void add_leaf(const Ros2Field& field, const Ros2TypeName& type, const std::string& path);

  std::vector<Ros2Message> messages_;
  std::vector<Ros2Leaf> leaves_;
  std::size_t size_ = cdr_head;
  std::size_t text_size_ = 0;  // of all paths and comments [B]
};

}  // namespace trocar
