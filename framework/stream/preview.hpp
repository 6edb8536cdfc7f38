// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "framework/recording/ros2_decode.hpp"
#include "framework/recording/row_layout.hpp"

namespace trocar::stream {

/// Rows of one thread, decimated for the eye: of each number the least, the greatest and the last
/// within a window of time, so that what lasted one tick is still seen. As a message it is the row
/// with a "trocar/Band" in each number's place:
///
///     float64 min
///     float64 max
///     float64 last
///
/// A number that is not finite does not count for the first two; they are NaN where none is finite.
class Preview {
 public:
  /// @param layout of the rows
  /// @param window [ns]
  Preview(const RowLayout& layout, std::int64_t window_ns);

  /// `ros2msg`, of "trocar/Preview".
  const std::string& schema() const { return schema_; }
  /// Takes a row. When it begins a new window, the one before is given.
  /// @return a CDR message, until the next call
  std::optional<std::span<const std::byte>> add(std::span<const std::byte> row);
  /// [ns] of the last row in the message that was given last.
  std::int64_t time_ns() const { return given_ns_; }
  /// What has come since the last message, if anything did.
  std::optional<std::span<const std::byte>> finish();

 private:
  struct Number {
    std::size_t offset;  // in the row
    Ros2Type type;
  };
  struct Band {
    double min, max, last;
  };
  void clear();
  std::span<const std::byte> give();

  std::int64_t window_ns_;
  std::string schema_;
  std::vector<Number> numbers_;
  std::vector<Band> bands_;
  std::vector<std::byte> message_;
  std::int64_t window_ = 0;  // number of the one that is being filled
  std::int64_t last_ns_ = 0;
  std::int64_t given_ns_ = 0;
  bool empty_ = true;
};

}  // namespace trocar::stream
