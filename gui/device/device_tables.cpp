// SPDX-License-Identifier: Apache-2.0
#include "gui/device/device_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gui/data/shown_number.hpp"
#include "gui/graph/graph_reading.hpp"

namespace trocar::gui {
namespace {

using Cell = CellTable::Cell;

constexpr double near_a_limit = 0.05;  // share of a range: there it is marked

std::vector<std::string> units_of(const GraphJson& port) {
  std::vector<std::string> units;
  for (const QString& one : QString::fromStdString(graph_text(port, "unit")).split(", "))
    units.push_back(one.toStdString());
  return units;
}

std::string unit_at(const std::vector<std::string>& units, std::size_t i) {
  return units.empty() ? "" : units[std::min(i, units.size() - 1)];
}

/// The velocity that is made of the device's position: its group's, or the first there is.
std::string velocity_of(const GraphJson& graph, const std::string& device) {
  for (const GraphJson& node : graph_list(graph, "nodes")) {
    const std::string name = graph_text(node, "name");
    if (graph_text(graph_entry(node, "outputs", "velocity"), "type") == "Joints" &&
        (name == device || graph_source(graph, name, "position") == device + ".position"))
      return name + ".velocity";
  }
  return "";
}

Cell number_cell(double value, const std::string& unit) {
  return {shown_number(value, unit), value};
}

Cell signal_cell(const DataStore& data, const std::string& port, std::size_t axis,
                 const std::string& unit) {
  if (port.empty()) return {"–", std::numeric_limits<double>::quiet_NaN()};
  return number_cell(newest_number(data, port + ".axis" + std::to_string(axis + 1)), unit);
}

/// A bar of where `value` stands between two limits; in words where it is close to one.
Cell range_cell(double value, double low, double high) {
  if (!std::isfinite(value) || !(high > low)) return {"–"};
  const double share = (value - low) / (high - low);
  Cell cell{"", {}, share};
  if (share < 0.0 || share > 1.0)
    cell.text = "BEYOND";
  else if (std::min(share, 1.0 - share) < near_a_limit)
    cell.text = "near its end";
  else
    cell.text = QString("%1 %").arg(100.0 * share, 0, 'f', 0);
  cell.number = share;
  cell.warning = std::min(share, 1.0 - share) < near_a_limit;
  return cell;
}

/// "-310 to -190 mm"
Cell limits_cell(double low, double high, const std::string& unit) {
  const auto text = [&](double value) {
    return QString::number(shown_value(value, unit).toDouble(), 'g', 5);
  };
  return {text(low) + " to " + text(high) + " " + shown_unit(unit), high};
}

struct AxisRange {
  double low, high;
};

std::optional<AxisRange> range_of_axis(const Scene& scene, const std::string& device,
                                       std::size_t axis) {
  if (!scene.laparoscope || scene.laparoscope->device != device || axis >= 6) return std::nullopt;
  const LaparoscopeLimits& limits = scene.laparoscope->limits;
  if (axis < 3) return AxisRange{limits.slider_low, limits.slider_high};
  const double middle = static_cast<double>(axis - 3) * 2.0 * std::numbers::pi / 3.0;
  return AxisRange{middle - limits.ring_travel, middle + limits.ring_travel};
}

QString axis_name(const Scene& scene, const std::string& device, std::size_t axis) {
  const QString number = QString::number(axis + 1);
  if (!scene.laparoscope || scene.laparoscope->device != device) return "axis " + number;
  return (axis < 3 ? "slider " : "ring ") + number;
}

CellTable::Row point_row(const QString& name, const std::optional<Eigen::Vector3d>& at,
                         const Eigen::Vector3d& force, bool has_force) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  CellTable::Row row = {{name}};
  for (int i = 0; i < 3; ++i) row.push_back(number_cell(at ? (*at)[i] : none, "m"));
  row.push_back(number_cell(has_force ? force.norm() : none, "N"));
  for (int i = 0; i < 3; ++i) row.push_back(number_cell(has_force ? force[i] : none, "N"));
  return row;
}

}  // namespace

JointSignals JointSignals::of(const GraphJson& graph) {
  JointSignals signals;
  for (const GraphJson& node : graph_list(graph, "nodes")) {
    const GraphJson& position = graph_entry(node, "outputs", "position");
    if (!graph_flag(node, "device") || graph_text(position, "type") != "Joints") continue;
    signals.device = graph_text(node, "name");
    signals.units = units_of(position);
    const GraphJson& sent = graph_entry(node, "outputs", "effort_sent");
    signals.effort_units = units_of(sent);
    signals.position = signals.device + ".position";
    signals.velocity = velocity_of(graph, signals.device);
    signals.asked = graph_source(graph, signals.device, "effort");
    signals.hold = graph_source(graph, signals.device, "hold");
    if (!sent.is_null()) signals.sent = signals.device + ".effort_sent";
    if (!graph_entry(node, "outputs", "effort_applied").is_null())
      signals.applied = signals.device + ".effort_applied";
    break;
  }
  return signals;
}

QStringList joint_header() {
  return {"axis",  "position", "in its range", "limits", "velocity",
          "asked", "hold",     "sent",         "applied"};
}

std::vector<CellTable::Row> joint_rows(const JointSignals& signals, const Scene& scene,
                                       const DataStore& data) {
  std::vector<CellTable::Row> rows;
  for (std::size_t i = 0; i < signals.units.size() && !signals.device.empty(); ++i) {
    const std::string unit = signals.units[i], effort = unit_at(signals.effort_units, i);
    const Cell position = signal_cell(data, signals.position, i, unit);
    const auto range = range_of_axis(scene, signals.device, i);
    rows.push_back({{axis_name(scene, signals.device, i)},
                    position,
                    range ? range_cell(position.number, range->low, range->high) : Cell{"–"},
                    range ? limits_cell(range->low, range->high, unit) : Cell{"–"},
                    signal_cell(data, signals.velocity, i, unit + "/s"),
                    signal_cell(data, signals.asked, i, effort),
                    signal_cell(data, signals.hold, i, effort),
                    signal_cell(data, signals.sent, i, effort),
                    signal_cell(data, signals.applied, i, effort)});
  }
  return rows;
}

QStringList range_header() {
  return {"of the mechanism", "now", "in its range", "limits", "margin"};
}

std::vector<CellTable::Row> range_rows(const Scene& scene, const MechanismPose& pose) {
  if (!scene.laparoscope || !pose.assembled) return {};
  const LaparoscopeLimits& limits = scene.laparoscope->limits;
  const LaparoscopeConfiguration& c = pose.mechanism;
  std::vector<CellTable::Row> rows;
  const auto add = [&](const QString& name, double value, double low, double high,
                       const std::string& unit) {
    // Of what begins at 0, only the far end is a limit.
    const double margin = low == 0.0 ? high - value : std::min(value - low, high - value);
    Cell range = range_cell(value, low, high);
    if (low == 0.0 && range.share >= 0.0 && range.share <= 1.0 - near_a_limit) {
      range.text = QString("%1 %").arg(100.0 * range.share, 0, 'f', 0);
      range.warning = false;
    }
    rows.push_back({{name},
                    number_cell(value, unit),
                    range,
                    limits_cell(low, high, unit),
                    number_cell(margin, unit)});
  };
  add("tilt of the tool", c.tool.tilt(), 0.0, limits.tilt, "rad");
  add("engagement", c.tool.engagement, limits.engagement_low, limits.engagement_high, "m");
  add("gimbal from the axis", c.rings.centre.norm(), 0.0, limits.centre_offset, "m");
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d link = c.delta.links.row(i);
    add(QString("rods of slider %1").arg(i + 1), std::atan2(link.head<2>().norm(), link.z()), 0.0,
        limits.link_angle, "rad");
  }
  return rows;
}

QStringList site_header() {
  return {"point", "x", "y", "z", "force", "Fx", "Fy", "Fz"};
}

std::vector<CellTable::Row> site_rows(const Scene& scene, const MechanismPose& pose,
                                      const DataStore& data) {
  std::vector<CellTable::Row> rows;
  for (std::size_t i = 0; i < scene.sites.size() && i < pose.sites.size(); ++i) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    bool has_force = false;
    for (const std::string& signal : scene.sites[i].forces)
      if (const auto force = newest_vector(data, signal)) {
        sum += *force;
        has_force = true;
      }
    rows.push_back(
        point_row(QString::fromStdString(scene.sites[i].name), pose.sites[i], sum, has_force));
  }
  for (const MechanismPose::Fixture& one : pose.fixtures)
    rows.push_back(point_row(QString::fromStdString(scene.fixtures[one.index].name), one.at,
                             one.force.value_or(Eigen::Vector3d::Zero()), one.force.has_value()));
  if (pose.force)
    rows.push_back(point_row("all, let through",
                             pose.assembled ? std::optional(pose.mechanism.tool.tip) : std::nullopt,
                             *pose.force, true));
  return rows;
}

}  // namespace trocar::gui
