// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "framework/recording/ros2_decode.hpp"
#include "framework/recording/schema_signals.hpp"
#include "gui/data/column.hpp"

namespace trocar::gui {

/// The newest rows of one thread as columns. Rows are numbered from 0 as they come.
class Track {
 public:
  /// @param name of the thread
  /// @param schema_name "trocar/Row", @param schema of its rows
  /// @param period_s [s] of the thread, 0: not known
  /// @param seconds that are kept
  /// @param memory [B] that all columns may take at most
  /// @throw std::invalid_argument when the schema is not one of rows
  Track(std::string name, std::string_view schema_name, std::string_view schema, double period_s,
        double seconds, std::size_t memory);

  const std::string& name() const { return name_; }
  const std::vector<SchemaSignal>& signal_list() const { return signals_; }
  std::optional<std::size_t> find(std::string_view signal) const;  // its column
  std::size_t row_size() const { return decoder_.size() - cdr_head; }

  /// @param row as CDR without head, of row_size() bytes
  void add(std::span<const std::byte> row);

  /// The row's tick is not behind that of the newest: it is another run's.
  bool is_before_end(std::span<const std::byte> row) const;
  double time_of(std::span<const std::byte> row) const;  // [s] of a row that may not be here

  std::uint64_t first() const { return times_.first(); }
  std::uint64_t end() const { return times_.end(); }
  bool empty() const { return end() == 0; }
  double time(std::uint64_t row) const { return times_[row]; }  // [s] of the slot
  std::int64_t tick(std::uint64_t row) const;
  const Column& column(std::size_t signal) const { return columns_[signal]; }
  /// The first row at or after `time` [s]; end() when there is none.
  std::uint64_t at(double time) const;
  /// Behind the last row that is shown: end(), or where DataStore::set_view_end() puts it.
  std::uint64_t view_end() const;
  void set_view_end(std::optional<double> time) { view_time_ = time; }
  /// Rows that are missing between those that came: the tick jumped.
  std::uint64_t missing() const { return missing_; }

 private:
  std::string name_;
  Ros2Decoder decoder_;
  std::vector<SchemaSignal> signals_;
  Column times_;
  std::vector<Column> columns_;
  std::size_t tick_ = 0, time_ = 0;  // columns
  std::uint64_t missing_ = 0;
  std::optional<double> view_time_;
};

}  // namespace trocar::gui
