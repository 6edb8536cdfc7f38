// SPDX-License-Identifier: Apache-2.0
#include "framework/stream/preview.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include "framework/recording/row_sink.hpp"

namespace trocar::stream {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::vector<Ros2Message> banded(std::vector<Ros2Message> messages) {
  for (Ros2Message& message : messages)
    for (Ros2Field& field : message.fields)
      if (find_ros2_type(field.type) != nullptr) field.type = "trocar/Band";
  messages.front().name = "trocar/Preview";
  messages.push_back({"trocar/Band",
                      {{"min", "float64", 0, "least within the window"},
                       {"max", "float64", 0, "greatest within the window"},
                       {"last", "float64", 0, "newest"}},
                      {}});
  return messages;
}

double number_of(std::span<const std::byte> row, std::size_t offset, Ros2Type type) {
  if (type == Ros2Type::boolean) return row[offset] == std::byte{0} ? 0.0 : 1.0;
  if (type == Ros2Type::float64) return number_at(row, offset);
  std::int64_t value;
  std::memcpy(&value, row.data() + offset, sizeof value);
  return static_cast<double>(value);
}

}  // namespace

Preview::Preview(const RowLayout& layout, std::int64_t window_ns)
    : window_ns_(window_ns), schema_(ros2_schema_text(banded(layout.messages()))) {
  const Ros2Decoder row("trocar/Row", ros2_schema_text(layout.messages()));
  for (const Ros2Leaf& leaf : row.leaves()) numbers_.push_back({leaf.offset - cdr_head, leaf.type});
  bands_.resize(numbers_.size());
  message_.resize(cdr_head + bands_.size() * sizeof(Band));
  message_[1] = std::byte{1};  // CDR, little-endian
  clear();
}

void Preview::clear() {
  for (Band& band : bands_) band = {nothing, nothing, nothing};
  empty_ = true;
}

std::optional<std::span<const std::byte>> Preview::add(std::span<const std::byte> row) {
  const std::int64_t time_ns = header_of(row).time;
  std::optional<std::span<const std::byte>> full;
  if (const std::int64_t window = time_ns / window_ns_; window != window_) {
    if (!empty_) full = give();
    window_ = window;
  }
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    const double value = number_of(row, numbers_[i].offset, numbers_[i].type);
    Band& band = bands_[i];
    band.last = value;
    if (!std::isfinite(value)) continue;
    if (!(value >= band.min)) band.min = value;
    if (!(value <= band.max)) band.max = value;
  }
  last_ns_ = time_ns;
  empty_ = false;
  return full;
}

std::span<const std::byte> Preview::give() {
  std::memcpy(message_.data() + cdr_head, bands_.data(), bands_.size() * sizeof(Band));
  given_ns_ = last_ns_;
  clear();
  return message_;
}

std::optional<std::span<const std::byte>> Preview::finish() {
  if (empty_) return std::nullopt;
  return give();
}

}  // namespace trocar::stream
