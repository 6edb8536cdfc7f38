// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "framework/event.hpp"
#include "framework/recording/row_layout.hpp"

namespace trocar {

/// Somebody who reads the rows and events of a run, on a thread of its own.
class RowSink {
 public:
  virtual ~RowSink() = default;
  /// What it is called where it lost something: "recorder".
  virtual std::string_view reader_name() const { return "a reader of rows"; }
  /// Whether a run in which it missed something counts as unsound.
  virtual bool needs_every_row() const { return true; }

  /// Before the first row. @param layouts one for each thread; they and the graph live until the
  /// run has ended
  virtual void begin(const std::vector<RowLayout>& /*layouts*/, const WiredGraph&) {}
  /// A row of the group-th thread. Each thread's rows and events come in their order.
  virtual void row(std::size_t group, std::span<const std::byte> row) = 0;
  virtual void event(std::size_t /*group*/, const Event&) {}
  /// It was too slow: so many rows and events came before the next one and are gone.
  virtual void missed(std::uint64_t /*records*/) {}
  virtual void end() {}
};

/// A reader of rows that was given up.
struct ReaderFailure {
  std::string reader;
  std::string why;
};

/// What a reader that fell behind missed in a run.
struct ReaderLoss {
  std::string reader;
  std::uint64_t records = 0;  // rows and events
  std::uint64_t gaps = 0;
  double time = 0.0;    // [s] of what came behind the first gap
  bool matters = true;  // the reader needs every row

  /// "recorder missed 120 rows in 2 gaps, the first before 3.214 s"
  std::string text() const;
};

/// That a reader missed something before this moment, for what it writes down.
Event missed_event(const char* reader, std::uint64_t records, std::int64_t tick,
                   std::int64_t time_ns);

RowHeader header_of(std::span<const std::byte> row);
double number_at(std::span<const std::byte> row, std::size_t offset);
/// One number of a row; integers and bools as doubles.
double signal_value(std::span<const std::byte> row, const RowSignal& signal);

}  // namespace trocar
