// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/row_snapshot.hpp"

namespace trocar {

void RowSnapshot::begin(const std::vector<RowLayout>& layouts, const WiredGraph&) {
  signals_.clear();
  rows_.clear();
  for (const RowLayout& layout : layouts) {
    for (RowSignal& signal : layout.signals()) {
      signal.group = rows_.size();
      signals_.push_back(std::move(signal));
    }
    rows_.emplace_back();
  }
}

std::optional<RowSnapshot::Value> RowSnapshot::value(const RowSignal& signal) const {
  const std::vector<std::byte> row = rows_[signal.group].get();
  if (row.empty()) return std::nullopt;
  return Value{signal_value(row, signal), static_cast<double>(header_of(row).time) * 1e-9};
}

}  // namespace trocar
