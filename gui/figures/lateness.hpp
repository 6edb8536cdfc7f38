// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gui/figures/result_file.hpp"

namespace trocar::gui {

/// How late the ticks of a thread began, from the rows of a log in real time. Bins and percentiles
/// are those of the run's report: 16 for each factor of two.
struct Lateness {
  struct Bin {
    double from = 0.0, to = 0.0;  // [s]
    std::size_t count = 0;
  };
  std::vector<Bin> bins;  // those that are not empty
  std::size_t count = 0;
  double p50 = 0.0, p99 = 0.0, p999 = 0.0, max = 0.0;  // [s]
};

/// @throw FigureError for a log of virtual time, too, where nothing is late
Lateness lateness_of(const ResultFile& file, int run, const std::string& thread);

/// "4000 ticks: 8.2 µs (median), 50 µs (99 %), 75 µs (99.9 %), 121 µs at worst".
std::string lateness_text(const Lateness& lateness);

}  // namespace trocar::gui
