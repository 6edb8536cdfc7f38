// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <array>
#include <optional>

#include "gui/analysis/plot_layout.hpp"
#include "gui/analysis/time_view.hpp"
#include "gui/data/cell_table.hpp"

namespace trocar::gui {

/// Cursors A and B [s], on the axis of a TimeWindow.
using Cursors = std::array<double, 2>;

/// The numbers of all signals of some plots, each with its unit: at the right edge, at the cursors
/// and between, and the statistics of what lies between the cursors or, without them, of all that
/// is shown.
class ValueTable {
 public:
  static QStringList header();

  /// A row, and the curve that it is of.
  struct Source {
    std::size_t plot = 0;
    std::string signal;
  };

  void fill(const DataStore& data, const std::vector<PlotDescription>& plots,
            const TimeWindow& window, const std::optional<Cursors>& cursors);
  const std::vector<CellTable::Row>& rows() const { return rows_; }
  const std::vector<Source>& sources() const { return sources_; }

  /// "B − A 120.0 ms, 8.333 Hz"
  static QString difference_text(const Cursors& cursors);

 private:
  std::vector<CellTable::Row> rows_;
  std::vector<Source> sources_;
};

}  // namespace trocar::gui
