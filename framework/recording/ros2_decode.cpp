// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/ros2_decode.hpp"

#include <algorithm>
#include <stdexcept>

namespace trocar {
namespace {

constexpr std::size_t max_leaves = 65536;
constexpr std::size_t max_text = std::size_t{64} << 20;  // [B]

Ros2Value read_value(CdrReader& reader, Ros2Type type) {
  switch (type) {
    case Ros2Type::boolean:
      return reader.boolean();
    case Ros2Type::int8:
      return std::int64_t{reader.number<std::int8_t>()};
    case Ros2Type::uint8:
      return std::uint64_t{reader.number<std::uint8_t>()};
    case Ros2Type::int16:
      return std::int64_t{reader.number<std::int16_t>()};
    case Ros2Type::uint16:
      return std::uint64_t{reader.number<std::uint16_t>()};
    case Ros2Type::int32:
      return std::int64_t{reader.number<std::int32_t>()};
    case Ros2Type::uint32:
      return std::uint64_t{reader.number<std::uint32_t>()};
    case Ros2Type::int64:
      return reader.number<std::int64_t>();
    case Ros2Type::uint64:
      return reader.number<std::uint64_t>();
    case Ros2Type::float32:
      return static_cast<double>(reader.number<float>());
    case Ros2Type::float64:
      return reader.number<double>();
    case Ros2Type::string:
      return reader.string();
  }
  throw std::logic_error("ros2msg: unknown type");
}

}  // namespace

double as_double(const Ros2Value& value) {
  return std::visit(
      [](auto held) {
        if constexpr (std::is_same_v<decltype(held), std::string_view>)
          return std::numeric_limits<double>::quiet_NaN();
        else
          return static_cast<double>(held);
      },
      value);
}

Ros2Decoder::Ros2Decoder(std::string_view schema_name, std::string_view schema_text)
    : messages_(parse_ros2_schema(schema_name, schema_text)) {
  expand(messages_.front(), "");
}

void Ros2Decoder::expand(const Ros2Message& message, const std::string& prefix) {
  for (const Ros2Field& field : message.fields) {
    const std::string path = prefix + field.name;
    if (field.array_length == 0) expand_field(field, path);
    for (std::uint32_t i = 0; i < field.array_length; ++i)
      expand_field(field, path + '[' + std::to_string(i) + ']');
  }
}

void Ros2Decoder::expand_field(const Ros2Field& field, const std::string& path) {
  if (const Ros2TypeName* type = find_ros2_type(field.type)) return add_leaf(field, *type, path);
  const auto nested = std::find_if(messages_.begin(), messages_.end(),
                                   [&](const auto& message) { return message.name == field.type; });
  expand(*nested, path + '.');
}

void Ros2Decoder::add_leaf(const Ros2Field& field, const Ros2TypeName& type,
                           const std::string& path) {
  text_size_ += path.size() + field.comment.size();
  if (leaves_.size() == max_leaves || text_size_ > max_text)
    throw std::invalid_argument("ros2msg: " + messages_.front().name + " has more than " +
                                std::to_string(max_leaves) +
                                " values, or their names are too long");
  Ros2Leaf leaf{path, type.type, Ros2Leaf::varies, field.comment};
  if (is_fixed_size()) {
    const std::size_t alignment = type.size == 0 ? sizeof(std::uint32_t) : type.size;
    leaf.offset = cdr_align(size_, alignment);
    size_ = type.size == 0 ? Ros2Leaf::varies : leaf.offset + type.size;
  }
  leaves_.push_back(std::move(leaf));
}

const Ros2Leaf* Ros2Decoder::find(std::string_view path) const {
  const auto found = std::find_if(leaves_.begin(), leaves_.end(),
                                  [&](const Ros2Leaf& leaf) { return leaf.path == path; });
  return found == leaves_.end() ? nullptr : &*found;
}

void Ros2Decoder::visit(std::span<const std::byte> message, const Visitor& visitor) const {
  CdrReader reader(message);
  for (const Ros2Leaf& leaf : leaves_) visitor(leaf, read_value(reader, leaf.type));
  constexpr std::size_t padding = 3;  // writers may fill the last four bytes
  if (reader.left() > padding)
    throw std::runtime_error("CDR: " + std::to_string(reader.left()) +
                             " bytes are left behind the last field of " + messages_.front().name);
}

Ros2Value Ros2Decoder::value(std::span<const std::byte> message, const Ros2Leaf& leaf) const {
  if (leaf.offset != Ros2Leaf::varies) {
    CdrReader reader(message, leaf.offset);
    return read_value(reader, leaf.type);
  }
  Ros2Value found;
  visit(message, [&](const Ros2Leaf& visited, const Ros2Value& value) {
    if (visited.path == leaf.path) found = value;
  });
  return found;
}

}  // namespace trocar
