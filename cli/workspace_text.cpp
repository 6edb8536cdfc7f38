// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "cli/text_table.hpp"
#include "cli/workspace_report.hpp"

namespace trocar::cli {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double mm = 1e-3;
constexpr double cm3 = 1e-6;
constexpr double most_columns = 9.0;  // of a map on a terminal

using Row = std::vector<std::string>;

std::string number(double value, int digits = 1) {
  if (std::isnan(value)) return "-";
  const std::string text = fmt::format("{:.{}f}", value, digits);
  return text.find_first_not_of("-0.") == std::string::npos ? text.substr(text.find('0')) : text;
}

std::string range_text(const Range& range, double unit) {
  return number(range.low / unit) + " to " + number(range.high / unit);
}

/// The last cell of a table's row stands at the left, so an empty one follows.
void add(TextTable& table, Row row) {
  row.emplace_back();
  table.row(std::move(row));
}

std::string figures_text(const WorkspaceReport& report) {
  const Workspace& w = report.sampled;
  const WorkspaceExtent& e = report.extent;
  TextTable table;
  table.row({"volume that the tip reaches",
             fmt::format("{} cm³, standard error {} cm³ ({:.2f} %)", number(w.volume / cm3),
                         number(w.standard_error / cm3), 100.0 * w.standard_error / w.volume)});
  table.row({"x of the tip", range_text(e.x, mm) + " mm"});
  table.row({"y", range_text(e.y, mm) + " mm"});
  table.row({"z", range_text(e.z, mm) + " mm"});
  table.row({"yaw (alpha)", range_text(e.yaw, degree) + " deg"});
  table.row({"pitch (beta)", range_text(e.pitch, degree) + " deg"});
  const double roll = report.translations.front().roll / degree;
  table.row({"roll (theta)", fmt::format("{} to {} deg on the axis", number(-roll), number(roll))});
  return table.text();
}

std::string ranges_text(const WorkspaceReport& report) {
  TextTable moved("lrrrrrr");
  Row translation = {"translation from the axis [mm]"},
      insertion = {"insertion, tool upright [mm]"}, roll = {"roll either way [deg]"};
  for (const auto& at : report.translations) {
    translation.push_back(number(at.translation / mm));
    insertion.push_back(number(at.insertion / mm));
    roll.push_back(number(at.roll / degree));
  }
  for (Row* row : {&translation, &insertion, &roll}) add(moved, std::move(*row));
  TextTable tilted("lrrrrrrr");
  Row depth = {"ball joint behind ring plane [mm]"}, tilt = {"tilt [deg]"};
  for (const auto& at : report.depths) {
    depth.push_back(number(at.depth / mm));
    tilt.push_back(number(at.tilt / degree));
  }
  add(tilted, std::move(depth));
  add(tilted, std::move(tilt));
  return "\nIn every direction:\n" + moved.text() + "\n" + tilted.text();
}

std::string engagement_text(const WorkspaceReport& report) {
  TextTable table("rrrrrrrrr");
  add(table, {"M [mm]", "poses", "cond.", "", "manip.", "peak", "", "cont.", ""});
  add(table, {"", "", "median", "most", "median", "least", "median", "least", "median"});
  for (const EngagementBand& band : report.engagement) {
    const DexteritySpread& d = band.dexterity;
    add(table,
        {fmt::format("{:.0f} to {:.0f}", band.engagement.low / mm, band.engagement.high / mm),
         fmt::format("{}", d.poses), number(d.condition.median), number(d.condition.greatest),
         number(d.manipulability.median, 2), number(d.peak_force.least),
         number(d.peak_force.median), number(d.continuous_force.least),
         number(d.continuous_force.median)});
  }
  return fmt::format(
             "\nBy engagement M of the tool; force [N] at the tip in the worst direction,\n{}:\n",
             report.with_weight ? "besides the weight" : "the weight not counted") +
         table.text();
}

struct MapOf {
  const char* title;
  Spread DexteritySpread::*figure;
  double Spread::*part;
  int digits;
};
constexpr std::array maps = {
    MapOf{"condition number, median", &DexteritySpread::condition, &Spread::median, 1},
    MapOf{"manipulability, median", &DexteritySpread::manipulability, &Spread::median, 2},
    MapOf{"peak force, least [N]", &DexteritySpread::peak_force, &Spread::least, 0},
    MapOf{"continuous force, least [N]", &DexteritySpread::continuous_force, &Spread::least, 1}};

std::string map_text(const WorkspaceProfile& profile, const MapOf& map) {
  const auto edges = [&](double low, std::size_t index) {
    const double from = low + profile.edge * static_cast<double>(index);
    return fmt::format("{:.0f}-{:.0f}", from / mm, (from + profile.edge) / mm);
  };
  TextTable table(std::string(20, 'r'));
  Row head = {"z \\ r"};
  for (std::size_t i = 0; i < profile.rows.front().size(); ++i) head.push_back(edges(0.0, i));
  add(table, std::move(head));
  for (std::size_t i = profile.rows.size(); i-- > 0;) {
    Row row = {edges(profile.low, i)};
    for (const DexteritySpread& square : profile.rows[i])
      row.push_back(number(square.*map.figure.*map.part, map.digits));
    add(table, std::move(row));
  }
  return fmt::format("\n{}\n", map.title) + table.text();
}

std::string maps_text(const WorkspaceReport& report) {
  double farthest = 0.0;
  for (const WorkspacePose& pose : report.sampled.poses)
    farthest = std::max(farthest, pose.tip.head<2>().norm());
  const double cell = report.sampled.grid.edge;
  const double edge = cell * std::ceil(farthest / (most_columns * cell));
  const WorkspaceProfile profile = workspace_profile(report.sampled.poses, edge);
  std::string text = "\nMaps, by height z of the tip and distance r from the axis [mm]:\n";
  for (const MapOf& map : maps) text += map_text(profile, map);
  return text;
}

}  // namespace

std::string workspace_text(const WorkspaceReport& report) {
  const Workspace& w = report.sampled;
  const std::string head = wrapped(
      fmt::format(
          "Workspace of the laparoscope: {} and {} tried with seed {}, {} inside all limits",
          counted(report.settings.shifts * report.settings.tips, "tip"),
          counted(w.poses_tried, "pose"), report.settings.seed, counted(w.poses.size(), "pose")),
      0);
  return head + "\n" + figures_text(report) + ranges_text(report) + engagement_text(report) +
         maps_text(report);
}

}  // namespace trocar::cli
