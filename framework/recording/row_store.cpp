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

RowStore::RowStore() : file_(std::tmpfile(), &std::fclose) {
  if (!file_) fail("no temporary file");
}

void RowStore::begin(const RowLayout& layout, const WiredGraph&) {
  row_size_ = layout.size();
  signals_ = layout.signals();
}

void RowStore::row(std::span<const std::byte> row) {
  if (std::fwrite(row.data(), row.size(), 1, file_.get()) != 1) fail("cannot write");
  ++rows_;
}

void RowStore::end() {
  if (std::fflush(file_.get()) != 0) fail("cannot write");
}

const RowSignal* RowStore::find(std::string_view name) const {
  for (const RowSignal& signal : signals_)
    if (signal.name == name) return &signal;
  return nullptr;
}

template <typename Take>
void RowStore::for_each_row(const Take& take) const {
  constexpr std::size_t rows_at_once = 512;
  std::vector<std::byte> block(rows_at_once * row_size_);
  std::rewind(file_.get());
  for (std::size_t done = 0; done < rows_;) {
    const std::size_t count = std::min(rows_at_once, rows_ - done);
    if (std::fread(block.data(), row_size_, count, file_.get()) != count) fail("cannot read");
    for (std::size_t i = 0; i < count; ++i)
      take(std::span<const std::byte>(block).subspan(i * row_size_, row_size_));
    done += count;
  }
}

std::vector<double> RowStore::column(const RowSignal& signal) const {
  std::vector<double> values;
  values.reserve(rows_);
  for_each_row([&](std::span<const std::byte> row) {
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

std::vector<double> RowStore::time() const {
  std::vector<double> values;
  values.reserve(rows_);
  for_each_row([&](std::span<const std::byte> row) {
    values.push_back(static_cast<double>(header_of(row).time) * 1e-9);
  });
  return values;
}

}  // namespace trocar
