// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/row_sink.hpp"

#include <fmt/format.h>

#include <cstring>

namespace trocar {

std::string ReaderLoss::text() const {
  return fmt::format("{} missed {} row{} {} {:.3f} s", reader, records, records == 1 ? "" : "s",
                     gaps == 1 ? "before" : fmt::format("in {} gaps, the first before", gaps),
                     time);
}

Event missed_event(const char* reader, std::uint64_t records, std::int64_t tick,
                   std::int64_t time_ns) {
  return {.kind = Event::Kind::rows_missed,
          .tick = tick,
          .time_ns = time_ns,
          .source = reader,
          .what = "it was too slow",
          .value = static_cast<double>(records)};
}

RowHeader header_of(std::span<const std::byte> row) {
  RowHeader header;
  std::memcpy(&header, row.data(), sizeof header);
  return header;
}

double number_at(std::span<const std::byte> row, std::size_t offset) {
  double number = 0.0;
  std::memcpy(&number, row.data() + offset, sizeof number);
  return number;
}

double signal_value(std::span<const std::byte> row, const RowSignal& signal) {
  if (signal.scalar == Scalar::real) return number_at(row, signal.row_offset);
  if (signal.scalar == Scalar::boolean) return row[signal.row_offset] == std::byte{0} ? 0.0 : 1.0;
  std::int64_t integer = 0;
  std::memcpy(&integer, row.data() + signal.row_offset, sizeof integer);
  return static_cast<double>(integer);
}

}  // namespace trocar
