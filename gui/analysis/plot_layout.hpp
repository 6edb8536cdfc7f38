// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gui/analysis/trigger.hpp"

namespace trocar::gui {

/// A plot: signals over time, or one over another.
struct PlotDescription {
  enum class Kind { time, xy };

  Kind kind = Kind::time;
  std::string title{};
  std::vector<std::string> names{};  // of kind xy: x, then y
  double height = 1.0;               // share, against the other plots

  bool operator==(const PlotDescription&) const = default;
};

/// A page of plots, as it is kept in a file: docs/dashboard.md#layouts.
struct PlotLayout {
  double span = 10.0;                              // [s]
  bool events = true;                              // are marked
  std::optional<std::array<double, 2>> cursors{};  // A and B [s], on the axis
  std::optional<TriggerSettings> trigger{};
  std::vector<PlotDescription> plots{};

  bool operator==(const PlotLayout&) const = default;
};

inline constexpr double least_span = 0.01, greatest_span = 600.0;  // [s]

QByteArray layout_text(const PlotLayout& layout);

/// @throw std::invalid_argument: where in the text, what is there, and what could be
PlotLayout read_layout(const QByteArray& text);

/// @throw std::runtime_error when the file cannot be read, and as above, with its name
PlotLayout read_layout_file(const QString& path);
/// @throw std::runtime_error when the file cannot be written
void write_layout_file(const QString& path, const PlotLayout& layout);

}  // namespace trocar::gui
