// SPDX-License-Identifier: Apache-2.0
#include "cli/workspace_report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/csv.hpp"
#include "cli/text_table.hpp"

namespace trocar::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr double band_width = 0.020;  // of engagement [m]
constexpr std::array shares_of_translation = {0.0, 1.0 / 3.0, 2.0 / 3.0, 5.0 / 6.0, 1.0};
constexpr int depths = 6;

struct Figure {
  const char* name;
  Spread DexteritySpread::*spread;
};
constexpr std::array figures = {Figure{"condition", &DexteritySpread::condition},
                                Figure{"manipulability", &DexteritySpread::manipulability},
                                Figure{"peak_force", &DexteritySpread::peak_force},
                                Figure{"continuous_force", &DexteritySpread::continuous_force}};

Json range_json(const Range& range) {
  return Json::array({range.low, range.high});
}

Json dexterity_json(const DexteritySpread& dexterity) {
  Json json = {{"poses", dexterity.poses}};
  for (const Figure& figure : figures) {
    const Spread& s = dexterity.*figure.spread;
    json[figure.name] = {{"least", s.least}, {"median", s.median}, {"greatest", s.greatest}};
  }
  return json;
}

Json settings_json(const std::vector<ParameterBase*>& parameters) {
  Json json = Json::object();
  for (ParameterBase* parameter : parameters) {
    const auto numbers = parameter->numbers();
    const bool whole = parameter->type_name() == "whole number";
    if (numbers.size() == 1)
      json[parameter->name()] = numbers.front();
    else if (whole)
      json[parameter->name()] = std::stoll(parameter->text());
    else
      json[parameter->name()] = parameter->text();
  }
  return json;
}

Json cells_json(const std::vector<WorkspaceCell>& cells) {
  Json list = Json::array();
  for (const WorkspaceCell& cell : cells) {
    const Eigen::Vector3d& c = cell.centre;
    Json json = {{"centre", {c.x(), c.y(), c.z()}}, {"filled", cell.filled}};
    json.update(dexterity_json(cell.dexterity));
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace

WorkspaceReport workspace_report(const WorkspaceSettings& settings,
                                 const ParallelOptions& options) {
  const LaparoscopeGeometry& geometry = settings.geometry;
  const LaparoscopeLimits& limits = settings.limits;
  WorkspaceReport report{.settings = settings};
  report.with_weight = !settings.gravity.isZero();
  report.sampled = sample_workspace(settings, options);
  report.extent = workspace_extent(settings, report.sampled.poses);
  for (const double share : shares_of_translation) {
    const double translation = share * limits.centre_offset;
    report.translations.push_back({translation, insertion_range(geometry, limits, translation),
                                   roll_range(geometry, limits, translation)});
  }
  for (int i = 0; i < depths; ++i) {
    const double depth =
        std::lerp(limits.engagement_low, limits.engagement_high, i / (depths - 1.0));
    report.depths.push_back({depth, tilt_range(geometry, limits, depth)});
  }
  report.engagement = by_engagement(report.sampled.poses, limits, band_width);
  report.cells = workspace_map(report.sampled);
  return report;
}

nlohmann::ordered_json workspace_json(const WorkspaceReport& report,
                                      const std::vector<ParameterBase*>& parameters) {
  const WorkspaceExtent& e = report.extent;
  Json json = {{"settings", settings_json(parameters)}, {"with_weight", report.with_weight}};
  json["tips_tried"] = report.settings.shifts * report.settings.tips;
  json["poses_tried"] = report.sampled.poses_tried;
  json["poses"] = report.sampled.poses.size();
  json["volume"] = report.sampled.volume;
  json["volume_standard_error"] = report.sampled.standard_error;
  json["extent"] = {{"x", range_json(e.x)},
                    {"y", range_json(e.y)},
                    {"z", range_json(e.z)},
                    {"yaw", range_json(e.yaw)},
                    {"pitch", range_json(e.pitch)}};
  json["translations"] = Json::array();
  for (const auto& [translation, insertion, roll] : report.translations)
    json["translations"].push_back(
        {{"translation", translation}, {"insertion", insertion}, {"roll", roll}});
  json["depths"] = Json::array();
  for (const auto& [depth, tilt] : report.depths)
    json["depths"].push_back({{"depth", depth}, {"tilt", tilt}});
  json["engagement"] = Json::array();
  for (const EngagementBand& band : report.engagement) {
    Json one = {{"engagement", range_json(band.engagement)}};
    one.update(dexterity_json(band.dexterity));
    json["engagement"].push_back(std::move(one));
  }
  json["cell"] = report.sampled.grid.edge;
  json["cells"] = cells_json(report.cells);
  return json;
}

std::string workspace_csv(const WorkspaceReport& report) {
  CsvLine header;
  header.add("x").add("y").add("z").add("filled").add("poses");
  for (const Figure& figure : figures)
    for (const char* part : {"_least", "_median", "_greatest"})
      header.add(std::string(figure.name) + part);
  std::string text = header.text();
  for (const WorkspaceCell& cell : report.cells) {
    CsvLine line;
    line.add(cell.centre.x()).add(cell.centre.y()).add(cell.centre.z()).add(cell.filled);
    line.add(static_cast<double>(cell.dexterity.poses));
    for (const Figure& figure : figures) {
      const Spread& s = cell.dexterity.*figure.spread;
      line.add(s.least).add(s.median).add(s.greatest);
    }
    text += line.text();
  }
  return text;
}

}  // namespace trocar::cli
