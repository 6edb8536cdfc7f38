// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPolygonF>
#include <QRectF>
#include <vector>

#include "gui/graph/graph_structure.hpp"

namespace trocar::gui {

/// Where the boxes of a graph are drawn, in pixels of its own: layers from left to right as the
/// wires go (after Sugiyama, Tagawa and Toda, IEEE Trans. SMC 11, 1981), lanes from top to bottom
/// for threads and groups, so that each is one rectangle. A wire that closes a loop goes back
/// beneath all.
struct GraphLayout {
  static constexpr double box_width = 148.0, box_height = 62.0;
  static constexpr double column_gap = 52.0, row_gap = 14.0;
  static constexpr double frame_margin = 12.0, frame_title = 20.0;

  struct Frame {
    QRectF rect;
    QString title;
    bool is_thread = false;
    int depth = 0;  // frames around it
  };
  struct Route {
    QPolygonF points;  // from the right of a box to the left of another
    bool back = false;
  };

  std::vector<QRectF> boxes{};  // of the structure's nodes
  std::vector<int> layers{};    // likewise
  std::vector<Frame> frames{};  // outer ones first
  std::vector<Route> routes{};  // of the structure's edges
  QRectF bounds{};

  static GraphLayout of(const GraphStructure& structure);
};

}  // namespace trocar::gui
