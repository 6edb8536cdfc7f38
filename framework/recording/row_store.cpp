// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/row_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace trocar {
namespace {

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(
      fmt::format("rows of the run: {} ({}); is there room in the folder for temporary files?",
                  what, std::strerror(errno)));
}

}  // namespace

bool RowStore::keeps(const std::string& name) const {
  return std::any_of(wanted_.begin(), wanted_.end(), [&](const std::string& wanted) {
    return name == wanted || name.starts_with(wanted + ".");
  });
}

void RowStore::begin(const std::vector<RowLayout>& layouts, const WiredGraph&) {
  for (const RowLayout& layout : layouts) {
    Group group{File(std::tmpfile(), &std::fclose), layout.size()};
    if (!group.file) fail("no temporary file");
    for (RowSignal& signal : layout.signals()) {
      if (!wanted_.empty() && !keeps(signal.name)) continue;
      signal.group = groups_.size();
      if (!wanted_.empty()) {
        group.picked.push_back(signal);
        signal.scalar = Scalar::real;
        signal.row_offset = sizeof(double) * group.picked.size();
      }
      by_name_.emplace(signal.name, signals_.size());
      signals_.push_back(std::move(signal));
    }
    if (!wanted_.empty()) {
      group.numbers.resize(1 + group.picked.size());
      group.row_size = sizeof(double) * group.numbers.size();
    }
    groups_.push_back(std::move(group));
  }
}

void RowStore::row(std::size_t index, std::span<const std::byte> row) {
  Group& group = groups_[index];
  std::span<const std::byte> kept = row;
  if (!wanted_.empty()) {
    group.numbers[0] = static_cast<double>(header_of(row).time) * 1e-9;
    for (std::size_t i = 0; i < group.picked.size(); ++i)
      group.numbers[i + 1] = signal_value(row, group.picked[i]);
    kept = std::as_bytes(std::span<const double>(group.numbers));
  }
  if (std::fwrite(kept.data(), kept.size(), 1, group.file.get()) != 1) fail("cannot write");
  ++group.rows;
}

void RowStore::end() {
  for (const Group& group : groups_)
    if (std::fflush(group.file.get()) != 0) fail("cannot write");
}

void RowStore::discard() {
  for (Group& group : groups_) {
    group.file.reset();
    group.rows = 0;
  }
}

const RowSignal* RowStore::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : &signals_[found->second];
}

template <typename Take>
void RowStore::for_each_row(std::size_t index, const Take& take) const {
  const Group& group = groups_[index];
  if (!group.file) return;
  constexpr std::size_t rows_at_once = 512;
  std::vector<std::byte> block(rows_at_once * group.row_size);
  std::rewind(group.file.get());
  for (std::size_t done = 0; done < group.rows;) {
    const std::size_t count = std::min(rows_at_once, group.rows - done);
    if (std::fread(block.data(), group.row_size, count, group.file.get()) != count)
      fail("cannot read");
    for (std::size_t i = 0; i < count; ++i)
      take(std::span<const std::byte>(block).subspan(i * group.row_size, group.row_size));
    done += count;
  }
}

std::vector<double> RowStore::column(const RowSignal& signal) const {
  std::vector<double> values;
  values.reserve(groups_[signal.group].rows);
  for_each_row(signal.group, [&](std::span<const std::byte> row) {
    values.push_back(signal_value(row, signal));
  });
  return values;
}

std::vector<double> RowStore::time(std::size_t group) const {
  std::vector<double> values;
  values.reserve(groups_[group].rows);
  for_each_row(group, [&](std::span<const std::byte> row) {
    values.push_back(wanted_.empty() ? static_cast<double>(header_of(row).time) * 1e-9
                                     : number_at(row, 0));
  });
  return values;
}

}  // namespace trocar
