// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "framework/recording/schema_signals.hpp"

namespace trocar::cli {

/// A signal of a channel, and what its messages said.
struct LogSignal : SchemaSignal {
  std::uint64_t count = 0;  // of values that were read
  double first = std::numeric_limits<double>::quiet_NaN();
  double last = std::numeric_limits<double>::quiet_NaN();
  double min = std::numeric_limits<double>::quiet_NaN();  // NaN values apart
  double max = std::numeric_limits<double>::quiet_NaN();

  void add(double value);
};

}  // namespace trocar::cli
