// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gui/analysis/time_view.hpp"
#include "gui/data/data_store.hpp"
#include "gui/plots/custom_plot.hpp"
#include "gui/theme/theme.hpp"

namespace trocar::gui {

/// Lines across a plot over time: cursors A and B, the level of a trigger, and what happened in the
/// run.
class PlotMarks {
 public:
  PlotMarks(QCustomPlot& plot, QCPLayer& layer);

  /// @param cursors [s] on the axis
  void set_cursors(const std::optional<std::array<double, 2>>& cursors);
  void set_level(std::optional<double> level);  // on the value axis
  const std::optional<double>& level() const { return level_at_; }
  void set_events_shown(bool shown) { events_shown_ = shown; }
  /// Those that people look for, from the newest; more than there is room for are left out.
  void show_events(const DataStore& data, const TimeWindow& window);
  void set_theme(const Theme& theme);

 private:
  struct Mark {
    QCPItemStraightLine* line = nullptr;
    QCPItemText* text = nullptr;

    void move(double at);
    void set_visible(bool visible);
    void set_colour(const QColor& colour, Qt::PenStyle style);
  };
  Mark make(QCPLayer& layer, const QString& text, bool at_top);

  QCustomPlot& plot_;
  std::array<Mark, 2> cursors_;
  std::vector<Mark> events_;
  QCPItemStraightLine* level_;
  std::optional<double> level_at_;
  bool events_shown_ = false;
};

}  // namespace trocar::gui
