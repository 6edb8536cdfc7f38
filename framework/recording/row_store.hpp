// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <memory>
#include <string_view>
#include <vector>

#include "framework/recording/row_sink.hpp"

namespace trocar {

/// All rows of a run, for an experiment to compute with. They lie in a temporary file without a
/// name, so that a long run does not fill the memory and nothing is left behind.
class RowStore final : public RowSink {
 public:
  RowStore();
  std::string_view reader_name() const override { return "rows of the run"; }
  void begin(const RowLayout& layout, const WiredGraph& graph) override;
  void row(std::span<const std::byte> row) override;
  void end() override;

  std::size_t rows() const { return rows_; }
  const std::vector<RowSignal>& signals() const { return signals_; }
  const RowSignal* find(std::string_view name) const;
  /// One number of every row; integers and bools as doubles.
  std::vector<double> column(const RowSignal& signal) const;
  /// [s] of every row.
  std::vector<double> time() const;

 private:
  template <typename Take>
  void for_each_row(const Take& take) const;

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::size_t row_size_ = 0;
  std::size_t rows_ = 0;
  std::vector<RowSignal> signals_;
};

}  // namespace trocar
