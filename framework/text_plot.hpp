// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "framework/units.hpp"

namespace trocar {

struct TextPlot {
  std::size_t width = 60;  // [characters] of the plot without its labels, at least 12
  std::size_t height = 8;
  Unit unit{};                     // of the values' labels
  std::optional<double> level{};   // a dashed line, always in view
  std::optional<double> marked{};  // [s] a mark below the axis
};

/// A signal as some lines of text, for a terminal or a test's report: dots of Braille, of which a
/// character has 2 × 4, so that a spike of one row stays visible.
/// @param time [s] of each value, ascending
std::string text_plot(std::span<const double> time, std::span<const double> values,
                      TextPlot plot = {});

}  // namespace trocar
