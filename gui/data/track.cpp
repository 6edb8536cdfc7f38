// SPDX-License-Identifier: Apache-2.0
#include "gui/data/track.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace trocar::gui {
namespace {

constexpr double unknown_rate = 10'000.0;  // [Hz], the highest there is

std::size_t rows_kept(double period_s, double seconds, std::size_t columns, std::size_t memory) {
  const double wanted = seconds * (period_s > 0 ? 1.0 / period_s : unknown_rate);
  // A value takes 8 bytes and its share of extremes another 1.1.
  const double room = static_cast<double>(memory) / (9.1 * static_cast<double>(columns + 1));
  return static_cast<std::size_t>(std::min(wanted, room));
}

template <typename Number>
double number_at(const std::byte* at) {
  Number number;
  std::memcpy(&number, at, sizeof number);
  return static_cast<double>(number);
}

double read(const std::byte* at, Ros2Type type) {
  switch (type) {
    case Ros2Type::boolean:
      return number_at<std::uint8_t>(at) != 0 ? 1.0 : 0.0;
    case Ros2Type::int8:
      return number_at<std::int8_t>(at);
    case Ros2Type::uint8:
      return number_at<std::uint8_t>(at);
    case Ros2Type::int16:
      return number_at<std::int16_t>(at);
    case Ros2Type::uint16:
      return number_at<std::uint16_t>(at);
    case Ros2Type::int32:
      return number_at<std::int32_t>(at);
    case Ros2Type::uint32:
      return number_at<std::uint32_t>(at);
    case Ros2Type::int64:
      return number_at<std::int64_t>(at);
    case Ros2Type::uint64:
      return number_at<std::uint64_t>(at);
    case Ros2Type::float32:
      return number_at<float>(at);
    case Ros2Type::float64:
      return number_at<double>(at);
    case Ros2Type::string:
      break;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Track::Track(std::string name, std::string_view schema_name, std::string_view schema,
             double period_s, double seconds, std::size_t memory)
    : name_(std::move(name)),
      decoder_(schema_name, schema),
      signals_(signals_of(parse_ros2_schema(schema_name, schema))),
      times_(rows_kept(period_s, seconds, signals_.size(), memory)),
      columns_(signals_.size(), times_) {
  const auto tick = find("tick"), time = find("time");
  if (!decoder_.is_fixed_size() || !tick || !time)
    throw std::invalid_argument(
        "\"" + name_ + "\" has no rows of Trocar: tick and time are missing, or texts are in them");
  tick_ = *tick;
  time_ = *time;
}

std::optional<std::size_t> Track::find(std::string_view signal) const {
  const auto found = std::find_if(signals_.begin(), signals_.end(),
                                  [&](const SchemaSignal& one) { return one.name == signal; });
  if (found == signals_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - signals_.begin());
}

void Track::add(std::span<const std::byte> row) {
  if (row.size() != row_size())
    throw std::invalid_argument("a row of " + name_ + " has " + std::to_string(row.size()) +
                                " bytes instead of " + std::to_string(row_size()));
  const std::vector<Ros2Leaf>& leaves = decoder_.leaves();
  for (std::size_t i = 0; i < leaves.size(); ++i)
    columns_[i].add(read(row.data() + leaves[i].offset - cdr_head, leaves[i].type));
  const std::uint64_t n = times_.end();
  times_.add(columns_[time_][n] / 1e9);
  if (n > 0 && tick(n) > tick(n - 1) + 1)
    missing_ += static_cast<std::uint64_t>(tick(n) - tick(n - 1) - 1);
}

bool Track::is_before_end(std::span<const std::byte> row) const {
  const Ros2Leaf& leaf = decoder_.leaves()[tick_];
  return !empty() && read(row.data() + leaf.offset - cdr_head, leaf.type) <=
                         static_cast<double>(tick(end() - 1));
}

double Track::time_of(std::span<const std::byte> row) const {
  const Ros2Leaf& leaf = decoder_.leaves()[time_];
  return 1e-9 * read(row.data() + leaf.offset - cdr_head, leaf.type);
}

std::int64_t Track::tick(std::uint64_t row) const {
  return static_cast<std::int64_t>(columns_[tick_][row]);
}

std::uint64_t Track::at(double time) const {
  std::uint64_t low = first(), high = end();
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    if (times_[middle] < time)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

std::uint64_t Track::view_end() const {
  if (!view_time_) return end();
  return at(std::nextafter(*view_time_, std::numeric_limits<double>::infinity()));
}

}  // namespace trocar::gui
