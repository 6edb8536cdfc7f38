// SPDX-License-Identifier: Apache-2.0
#include "cli/log_signals.hpp"

#include <cmath>

namespace trocar::cli {

void LogSignal::add(double value) {
  if (count++ == 0) first = value;
  last = value;
  // fmin and fmax pass over NaN.
  min = std::fmin(min, value);
  max = std::fmax(max, value);
}

}  // namespace trocar::cli
