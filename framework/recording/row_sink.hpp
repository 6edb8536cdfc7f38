// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "framework/event.hpp"
#include "framework/recording/row_layout.hpp"

namespace trocar {

/// Somebody who reads the rows and events of a run, on the pump's thread, in the loop's order.
class RowSink {
 public:
  virtual ~RowSink() = default;
  /// Before the first row. The layout and the graph live until the run has ended.
  virtual void begin(const RowLayout&, const WiredGraph&) {}
  virtual void row(std::span<const std::byte> row) = 0;
  virtual void event(const Event&) {}
  virtual void end() {}
};

RowHeader header_of(std::span<const std::byte> row);
double number_at(std::span<const std::byte> row, std::size_t offset);

}  // namespace trocar
