// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "framework/recording/row_sink.hpp"

namespace trocar {

/// All rows of a run, for an experiment to compute with. Those of each thread lie in a temporary
/// file without a name, so that a long run does not fill the memory and nothing is left behind.
/// Where only some signals are kept, a row is their numbers as doubles, after its time.
class RowStore final : public RowSink {
 public:
  /// @param wanted signals that are kept, or the whole ports or groups that they stand for; all
  /// when empty
  explicit RowStore(std::vector<std::string> wanted = {}) : wanted_(std::move(wanted)) {}
  void begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) override;
  void row(std::size_t group, std::span<const std::byte> row) override;
  void end() override;
  /// Gives the rows back to the machine; as if there had been none.
  void discard();

  std::size_t rows(std::size_t group = 0) const { return groups_[group].rows; }
  const std::vector<RowSignal>& signals() const { return signals_; }
  const RowSignal* find(std::string_view name) const;
  /// One number of every row of its thread; integers and bools as doubles.
  std::vector<double> column(const RowSignal& signal) const;
  /// [s] of every row of a thread.
  std::vector<double> time(std::size_t group = 0) const;

 private:
  using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
  struct Group {  // a thread's rows
    File file;
    std::size_t row_size = 0;
    std::size_t rows = 0;
    std::vector<RowSignal> picked{};  // where what is kept stands in a whole row
    std::vector<double> numbers{};    // of the row that is being written
  };
  bool keeps(const std::string& name) const;
  template <typename Take>
  void for_each_row(std::size_t group, const Take& take) const;

  std::vector<std::string> wanted_;
  std::vector<Group> groups_;
  std::vector<RowSignal> signals_;
  std::map<std::string, std::size_t, std::less<>> by_name_;  // in signals_
};

}  // namespace trocar
