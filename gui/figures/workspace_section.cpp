// SPDX-License-Identifier: Apache-2.0
#include "gui/figures/workspace_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "framework/text.hpp"

namespace trocar::gui {
namespace {

using Column = std::vector<double>;

const Column& column(const NumberTable& table, const std::string& name, const std::string& needs) {
  if (const Column* found = table.column(name)) return *found;
  throw FigureError(
      fmt::format("{}; there is no column {}{}", needs, name, suggestion(name, table.names)));
}

/// The least distance between two coordinates.
double edge_of(Column values) {
  std::sort(values.begin(), values.end());
  double edge = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < values.size(); ++i)
    if (const double gap = values[i] - values[i - 1]; gap > 1e-9) edge = std::min(edge, gap);
  return edge;
}

WorkspaceSection section(const Column& across, const Column& up, const Column& through, double at,
                         const Column& values, double edge) {
  WorkspaceSection section{.at = at, .cells = {}};
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::abs(through[i] - at) < 0.25 * edge)
      section.cells.push_back({across[i], up[i], values[i]});
  return section;
}

double nearest_to_zero(const Column& values) {
  double nearest = values.front();
  for (const double value : values)
    if (std::abs(value) < std::abs(nearest) - 1e-9 ||
        (std::abs(value) < std::abs(nearest) + 1e-9 && value > nearest))
      nearest = value;
  return nearest;
}

double fullest(const Column& heights, const Column& filled) {
  std::map<long, std::pair<double, double>> sums;  // by height [µm]
  for (std::size_t i = 0; i < heights.size(); ++i) {
    auto& [sum, height] = sums[std::lround(1e6 * heights[i])];
    if (std::isfinite(filled[i])) sum += filled[i];
    height = heights[i];
  }
  return std::max_element(
             sums.begin(), sums.end(),
             [](const auto& a, const auto& b) { return a.second.first < b.second.first; })
      ->second.second;
}

}  // namespace

WorkspaceSections workspace_sections(const ResultFile& file, const std::string& quantity) {
  const std::string needs = "workspace needs the map that `trocar workspace --csv FILE.csv` writes";
  if (file.table() == nullptr) throw FigureError(needs + "; this is " + file.contents());
  const NumberTable& table = *file.table();
  const Column& x = column(table, "x", needs);
  const Column& y = column(table, "y", needs);
  const Column& z = column(table, "z", needs);
  const Column& filled = column(table, "filled", needs);
  const Column& values = column(table, quantity, needs);
  if (x.empty()) throw FigureError(needs + "; this one has no cells");
  WorkspaceSections all;
  all.quantity = quantity;
  all.edge = std::min({edge_of(x), edge_of(y), edge_of(z)});
  if (!std::isfinite(all.edge)) throw FigureError(needs + "; this one has a single cell");
  all.side = section(x, z, y, nearest_to_zero(y), values, all.edge);
  all.top = section(x, y, z, fullest(z, filled), values, all.edge);
  all.least = std::numeric_limits<double>::infinity();
  all.greatest = -all.least;
  for (const WorkspaceSection* each : {&all.side, &all.top})
    for (const WorkspaceSection::Cell& cell : each->cells) {
      if (!std::isfinite(cell.value)) continue;
      all.least = std::min(all.least, cell.value);
      all.greatest = std::max(all.greatest, cell.value);
    }
  if (all.least > all.greatest) throw FigureError(quantity + " has no numbers in these sections");
  return all;
}

std::string quantity_text(const std::string& column) {
  const std::size_t end = column.rfind('_');
  std::string name = column.substr(0, end);
  std::replace(name.begin(), name.end(), '_', ' ');
  if (!name.empty() && name[0] >= 'a' && name[0] <= 'z')
    name[0] = static_cast<char>(name[0] - 'a' + 'A');
  if (column == "filled") return "Share that is reached";
  if (end != std::string::npos) name += ", " + column.substr(end + 1);
  return column.find("force") == std::string::npos ? name : name + " [N]";
}

}  // namespace trocar::gui
