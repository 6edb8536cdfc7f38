// SPDX-License-Identifier: Apache-2.0
#include "cli/log_signals.hpp"

#include <fnmatch.h>

#include <cmath>

namespace trocar::cli {

void LogSignal::add(double value) {
  if (count++ == 0) first = value;
  last = value;
  // fmin and fmax pass over NaN.
  min = std::fmin(min, value);
  max = std::fmax(max, value);
}

bool matches(std::string_view pattern, const std::string& name) {
  if (pattern.find_first_of("*?") == std::string_view::npos)
    return name.find(pattern) != std::string::npos;
  return ::fnmatch(std::string(pattern).c_str(), name.c_str(), FNM_NOESCAPE) == 0;
}

}  // namespace trocar::cli
