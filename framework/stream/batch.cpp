// SPDX-License-Identifier: Apache-2.0
#include "framework/stream/batch.hpp"

#include <fmt/format.h>

#include <cstring>
#include <stdexcept>

#include "framework/recording/cdr.hpp"
#include "framework/recording/row_sink.hpp"

namespace trocar::stream {
namespace {

constexpr std::size_t batch_head = cdr_head + 8;  // CDR's, the count, and what aligns the first row

std::size_t stride_of(std::size_t row_size) {
  return (row_size + 7) / 8 * 8;
}

}  // namespace

Batch::Batch(const RowLayout& layout)
    : schema_(fmt::format("trocar/Row[] rows\n{:=<80}\nMSG: trocar/Row\n{}", "",
                          ros2_schema_text(layout.messages()))),
      row_size_(layout.size()) {}

void Batch::add(std::span<const std::byte> row) {
  if (count_ == 0) {
    message_.assign(batch_head, std::byte{0});
    message_[1] = std::byte{1};  // CDR, little-endian
  }
  message_.resize(batch_head + count_ * stride_of(row_size_));
  message_.insert(message_.end(), row.begin(), row.end());
  ++count_;
  last_ns_ = header_of(row).time;
}

std::span<const std::byte> Batch::take() {
  std::memcpy(message_.data() + cdr_head, &count_, sizeof count_);
  count_ = 0;
  return message_;
}

std::vector<std::span<const std::byte>> Batch::rows(std::span<const std::byte> message,
                                                    std::size_t row_size) {
  CdrReader cdr(message);
  const auto count = cdr.number<std::uint32_t>();
  const std::size_t room = message.size() < batch_head ? 0 : message.size() - batch_head;
  const std::size_t stride = stride_of(row_size);
  if (row_size == 0 || (count == 0 ? room > 0 : room != (count - 1) * stride + row_size))
    throw std::runtime_error(fmt::format("a batch of {} rows of {} bytes cannot be {} bytes long",
                                         count, row_size, message.size()));
  std::vector<std::span<const std::byte>> rows;
  for (std::size_t i = 0; i < count; ++i)
    rows.push_back(message.subspan(batch_head + i * stride, row_size));
  return rows;
}

}  // namespace trocar::stream
