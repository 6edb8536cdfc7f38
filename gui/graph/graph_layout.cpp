// SPDX-License-Identifier: Apache-2.0
#include "gui/graph/graph_layout.hpp"

#include <algorithm>
#include <map>

#include "gui/graph/graph_lanes.hpp"
#include "gui/graph/graph_layers.hpp"

namespace trocar::gui {
namespace {

constexpr double pitch = GraphLayout::box_width + GraphLayout::column_gap;
constexpr double way_height = 10.0;  // of a wire that passes a column
constexpr double back_gap = 10.0;    // between wires that go back
constexpr int sweeps = 6;

/// A box, or a wire on its way past a column.
struct LaidItem {
  int layer = 0;
  std::size_t lane = 0;
  double height = GraphLayout::box_height;
  double y = 0.0;                              // of its top
  std::vector<std::size_t> before{}, after{};  // items that wires come from and go to
  double middle() const { return y + 0.5 * height; }
};

class LayoutMaker {
 public:
  explicit LayoutMaker(const GraphStructure& structure)
      : structure_(structure), layers_(GraphLayers::of(structure)), lanes_(lanes_of(structure)) {}

  GraphLayout make() {
    add_items();
    stack();
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      sort_columns(sweep % 2 == 0);
      stack();
    }
    take_boxes();
    take_frames();
    take_routes();
    return std::move(layout_);
  }

 private:
  void add_items() {
    for (std::size_t node = 0; node < structure_.nodes.size(); ++node)
      items_.push_back({.layer = layers_.layer[node], .lane = lanes_.of_node[node]});
    ways_.resize(structure_.edges.size());
    for (std::size_t i = 0; i < structure_.edges.size(); ++i)
      if (!layers_.back[i]) add_way(i);
    for (std::size_t i = 0; i < items_.size(); ++i) {
      auto& columns = columns_[items_[i].lane];
      columns.resize(std::max(columns.size(), static_cast<std::size_t>(items_[i].layer) + 1));
      columns[static_cast<std::size_t>(items_[i].layer)].push_back(i);
    }
  }

  /// Wires from one box share their way.
  void add_way(std::size_t edge) {
    const std::size_t from = structure_.edges[edge].from, to = structure_.edges[edge].to;
    std::size_t last = from;
    for (int layer = items_[from].layer + 1; layer < items_[to].layer; ++layer) {
      const auto [way, is_new] = shared_.try_emplace({from, layer}, items_.size());
      if (is_new) {
        items_.push_back({.layer = layer, .lane = items_[from].lane, .height = way_height});
        join(last, way->second);
      }
      last = way->second;
      ways_[edge].push_back(last);
    }
    join(last, to);
  }
  void join(std::size_t from, std::size_t to) {
    items_[from].after.push_back(to);
    items_[to].before.push_back(from);
  }

  /// By the mean height of what is wired to it on one side.
  void sort_columns(bool by_before) {
    for (auto& [lane, columns] : columns_)
      for (std::vector<std::size_t>& column : columns) {
        std::map<std::size_t, double> wanted;
        for (const std::size_t item : column) {
          const auto& others = by_before ? items_[item].before : items_[item].after;
          double sum = 0.0;
          for (const std::size_t other : others) sum += items_[other].middle();
          wanted[item] =
              others.empty() ? items_[item].middle() : sum / static_cast<double>(others.size());
        }
        std::stable_sort(column.begin(), column.end(),
                         [&](std::size_t a, std::size_t b) { return wanted.at(a) < wanted.at(b); });
      }
  }

  void stack() { stack_lane(0, 0.0); }

  /// @return where it ends [pixels]
  double stack_lane(std::size_t lane, double top) {
    const double margin = lane == 0 ? 0.0 : GraphLayout::frame_margin;
    double y = top + (lane == 0 ? 0.0 : GraphLayout::frame_title);
    for (const std::size_t inner : lanes_.lanes[lane].inner)
      y = stack_lane(inner, y + GraphLayout::row_gap);
    double tallest = 0.0;
    for (const auto& column : columns_[lane]) tallest = std::max(tallest, height_of(column));
    if (tallest > 0.0) y += GraphLayout::row_gap;
    for (const auto& column : columns_[lane]) {
      double at = y + 0.5 * (tallest - height_of(column));
      for (const std::size_t item : column) {
        items_[item].y = at;
        at += items_[item].height + GraphLayout::row_gap;
      }
    }
    lane_spans_[lane] = {top, y + tallest + margin};
    return y + tallest + margin;
  }
  double height_of(const std::vector<std::size_t>& column) const {
    double height = 0.0;
    for (const std::size_t item : column) height += items_[item].height + GraphLayout::row_gap;
    return std::max(0.0, height - GraphLayout::row_gap);
  }

  void take_boxes() {
    for (std::size_t node = 0; node < structure_.nodes.size(); ++node) {
      layout_.boxes.emplace_back(items_[node].layer * pitch, items_[node].y, GraphLayout::box_width,
                                 GraphLayout::box_height);
      layout_.layers.push_back(items_[node].layer);
      layout_.bounds |= layout_.boxes.back();
    }
  }

  void take_frames() {
    for (std::size_t lane = 1; lane < lanes_.lanes.size(); ++lane) {
      int low = 1 << 20, high = -1;
      for (std::size_t node = 0; node < structure_.nodes.size(); ++node)
        if (lanes_.holds(lane, lanes_.of_node[node])) {
          low = std::min(low, items_[node].layer);
          high = std::max(high, items_[node].layer);
        }
      if (high < 0) continue;
      const double inner = GraphLayout::frame_margin / (1.0 + lanes_.lanes[lane].depth);
      const double left = low * pitch - 2.0 * inner;
      const double right = high * pitch + GraphLayout::box_width + 2.0 * inner;
      const auto [top, bottom] = lane_spans_[lane];
      layout_.frames.push_back({QRectF(left, top, right - left, bottom - top),
                                lanes_.lanes[lane].title, lanes_.lanes[lane].is_thread,
                                lanes_.lanes[lane].depth});
      layout_.bounds |= layout_.frames.back().rect;
    }
    std::stable_sort(layout_.frames.begin(), layout_.frames.end(),
                     [](const auto& a, const auto& b) { return a.depth < b.depth; });
  }

  /// Spread over the side of a box, in an order in which they do not cross.
  double place_at_side(std::size_t node, bool outgoing, std::size_t edge) const {
    std::vector<std::pair<double, std::size_t>> others;
    for (std::size_t i = 0; i < structure_.edges.size(); ++i) {
      const GraphStructure::Edge& one = structure_.edges[i];
      if ((outgoing ? one.from : one.to) != node) continue;
      const std::size_t next = ways_[i].empty() ? (outgoing ? one.to : one.from)
                               : outgoing       ? ways_[i].front()
                                                : ways_[i].back();
      others.emplace_back(layers_.back[i] ? 1e9 : items_[next].middle(), i);
    }
    std::sort(others.begin(), others.end());
    const auto at = std::find_if(others.begin(), others.end(),
                                 [&](const auto& one) { return one.second == edge; });
    return items_[node].y + GraphLayout::box_height *
                                (static_cast<double>(at - others.begin()) + 1.0) /
                                (static_cast<double>(others.size()) + 1.0);
  }

  void take_routes() {
    const double floor = layout_.bounds.bottom() + 16.0;
    int backs = 0;
    for (std::size_t i = 0; i < structure_.edges.size(); ++i) {
      const GraphStructure::Edge& edge = structure_.edges[i];
      const QPointF start(layout_.boxes[edge.from].right(), place_at_side(edge.from, true, i));
      const QPointF end(layout_.boxes[edge.to].left(), place_at_side(edge.to, false, i));
      GraphLayout::Route route{{start}, layers_.back[i]};
      if (route.back) {
        const double y = floor + back_gap * backs;
        const double aside = 13.0 + 4.0 * (backs++ % 8);
        route.points << QPointF(start.x() + aside, start.y()) << QPointF(start.x() + aside, y)
                     << QPointF(end.x() - aside, y) << QPointF(end.x() - aside, end.y());
      }
      for (const std::size_t way : ways_[i]) {
        const double x = items_[way].layer * pitch, y = items_[way].middle();
        route.points << QPointF(x, y) << QPointF(x + GraphLayout::box_width, y);
      }
      route.points << end;
      layout_.bounds |= route.points.boundingRect();
      layout_.routes.push_back(std::move(route));
    }
  }

  const GraphStructure& structure_;
  GraphLayers layers_;
  GraphLanes lanes_;
  std::vector<LaidItem> items_;                 // of the nodes first
  std::vector<std::vector<std::size_t>> ways_;  // of edges: items that they pass
  std::map<std::pair<std::size_t, int>, std::size_t> shared_;
  std::map<std::size_t, std::vector<std::vector<std::size_t>>> columns_;  // of lanes
  std::map<std::size_t, std::pair<double, double>> lane_spans_;           // top and bottom
  GraphLayout layout_;
};

}  // namespace

GraphLayout GraphLayout::of(const GraphStructure& structure) {
  return LayoutMaker(structure).make();
}

}  // namespace trocar::gui
