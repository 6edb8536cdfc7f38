// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "framework/realtime/shared_bytes.hpp"
#include "framework/recording/row_sink.hpp"

namespace trocar {

/// The newest row of each thread, for somebody who looks now and then from another thread. A run's
/// signals are known from begin() on, which returns before the run's first tick.
class RowSnapshot final : public RowSink {
 public:
  std::string_view reader_name() const override { return "snapshot"; }
  bool needs_every_row() const override { return false; }
  void begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) override;
  void row(std::size_t group, std::span<const std::byte> row) override { rows_[group].put(row); }

  const std::vector<RowSignal>& signals() const { return signals_; }

  struct Value {
    double number = 0.0;  // in SI; integers, true and false as numbers
    double time = 0.0;    // [s] of the row
  };
  /// Nothing before the first row.
  std::optional<Value> value(const RowSignal& signal) const;

 private:
  std::vector<RowSignal> signals_;
  std::deque<SharedBytes> rows_;  // of each thread
};

}  // namespace trocar
