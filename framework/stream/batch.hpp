// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "framework/recording/row_layout.hpp"

namespace trocar::stream {

/// Rows of one thread, many in a message, for those who want every one of them: at 10 kHz a
/// message for each costs more than what is in it. As a message, "trocar/Batch":
///
///     trocar/Row[] rows
///
/// In CDR that is the number of rows in 4 bytes, and from the 8th byte the rows, each beginning at
/// a multiple of 8.
class Batch {
 public:
  explicit Batch(const RowLayout& layout);

  const std::string& schema() const { return schema_; }
  void add(std::span<const std::byte> row);
  std::uint32_t count() const { return count_; }
  std::int64_t time_ns() const { return last_ns_; }  // of the last row
  /// What has been added, as a CDR message, until the next add().
  std::span<const std::byte> take();

  /// One row of a message with its head as a "trocar/Row", as CDR without head.
  /// @param row_size [B] of the schema's row, without a head
  /// @throw std::runtime_error when the message is not as long as it says
  static std::vector<std::span<const std::byte>> rows(std::span<const std::byte> message,
                                                      std::size_t row_size);

 private:
  std::string schema_;
  std::size_t row_size_;
  std::vector<std::byte> message_;
  std::uint32_t count_ = 0;
  std::int64_t last_ns_ = 0;
};

}  // namespace trocar::stream
