// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/row_store.hpp"

#include <fmt/format.h>

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

void RowStore::begin(const std::vector<RowLayout>& layouts, const WiredGraph&) {
  for (const RowLayout& layout : layouts) {
    for (RowSignal& signal : layout.signals()) {
      signal.group = groups_.size();
      by_name_.emplace(signal.name, signals_.size());
      signals_.push_back(std::move(signal));
    }
    groups_.push_back({File(std::tmpfile(), &std::fclose), layout.size(), 0});
    if (!groups_.back().file) fail("no temporary file");
  }
}

void RowStore::row(std::size_t group, std::span<const std::byte> row) {
  if (std::fwrite(row.data(), row.size(), 1, groups_[group].file.get()) != 1) fail("cannot write");
  ++groups_[group].rows;
}

void RowStore::end() {
  for (const Group& group : groups_)
    if (std::fflush(group.file.get()) != 0) fail("cannot write");
}

const RowSignal* RowStore::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : &signals_[found->second];
}

template <typename Take>
void RowStore::for_each_row(std::size_t index, const Take& take) const {
  const Group& group = groups_[index];
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
    if (signal.scalar == Scalar::real) {
      values.push_back(number_at(row, signal.row_offset));
    } else if (signal.scalar == Scalar::integer) {
      std::int64_t integer = 0;
      std::memcpy(&integer, row.data() + signal.row_offset, sizeof integer);
      values.push_back(static_cast<double>(integer));
    } else {
      values.push_back(row[signal.row_offset] == std::byte{0} ? 0.0 : 1.0);
    }
  });
  return values;
}

std::vector<double> RowStore::time(std::size_t group) const {
  std::vector<double> values;
  values.reserve(groups_[group].rows);
  for_each_row(group, [&](std::span<const std::byte> row) {
    values.push_back(static_cast<double>(header_of(row).time) * 1e-9);
  });
  return values;
}

}  // namespace trocar
