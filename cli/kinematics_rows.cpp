// SPDX-License-Identifier: Apache-2.0
#include "cli/kinematics_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "cli/output.hpp"
#include "components/kinematics/laparoscope_gravity.hpp"
#include "components/kinematics/laparoscope_limits.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

using Names = std::vector<std::string>;

const Names actuators = {"q1", "q2", "q3", "phi1", "phi2", "phi3"};
const Names six_dof = {"xd", "yd", "zd", "xt", "yt", "thetat"};
const Names pose = {"xe", "ye", "ze", "alpha", "beta", "theta"};

template <typename Owner>
struct Setting {
  const char* column;
  double Owner::*member;
  const char* name;  // as errors call it
};
using Geometry = LaparoscopeGeometry;
using Masses = LaparoscopeMasses;
constexpr std::array geometry_columns = {
    Setting<Geometry>{"l", &Geometry::tool_length, "tool_length"},
    Setting<Geometry>{"zt", &Geometry::ring_plane, "ring_plane"},
    Setting<Geometry>{"r", &Geometry::ring_radius, "ring_radius"},
    Setting<Geometry>{"Rb", &Geometry::base_radius, "base_radius"},
    Setting<Geometry>{"Rp", &Geometry::platform_radius, "platform_radius"},
    Setting<Geometry>{"L", &Geometry::link_length, "link_length"}};
constexpr std::array mass_columns = {Setting<Masses>{"m_sl", &Masses::slider, "slider"},
                                     Setting<Masses>{"m_lk", &Masses::link_pair, "link_pair"},
                                     Setting<Masses>{"m_pl", &Masses::platform, "platform"},
                                     Setting<Masses>{"m_tool", &Masses::tool, "tool"},
                                     Setting<Masses>{"s_tool", &Masses::tool_centre, "tool_centre"},
                                     Setting<Masses>{"m_ee", &Masses::end_effector, "end_effector"},
                                     Setting<Masses>{"m_pin", &Masses::pin, "pin"}};
constexpr std::array gravity_columns = {"gx", "gy", "gz"};

Names operator+(Names names, const Names& more) {
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

/// "J11" to "J66".
Names matrix(const std::string& name, int size) {
  Names names;
  for (int i = 1; i <= size; ++i)
    for (int j = 1; j <= size; ++j) names.push_back(fmt::format("{}{}{}", name, i, j));
  return names;
}

template <typename Derived>
void append(std::vector<double>& values, const Eigen::MatrixBase<Derived>& m) {
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (Eigen::Index j = 0; j < m.cols(); ++j) values.push_back(m(i, j));
}

KinematicsResult refusal(AssemblyStatus status) {
  return {{}, describe(status), ""};
}

std::string limits_of(const LaparoscopeConfiguration& configuration) {
  const LimitSet violated = violated_limits(LaparoscopeLimits(), configuration);
  Names names;
  for (unsigned i = 0; i < LimitSet::count; ++i)
    if (violated.has(i)) names.emplace_back(LimitSet::name(i));
  return join(names, ";");
}

KinematicsResult forward(const KinematicsRow& row) {
  LaparoscopeConfiguration c;
  const AssemblyStatus status = LaparoscopeModel(row.geometry).forward(row.given, c);
  if (status != AssemblyStatus::ok) return refusal(status);
  const PoseCoordinates at = c.tool.pose();
  KinematicsResult result{{}, "", limits_of(c)};
  append(result.values, c.tool.coordinates());
  append(result.values, at.tip);
  append(result.values, Eigen::Vector3d(at.alpha, at.beta, at.theta));
  append(result.values, c.tool.rotation);
  return result;
}

KinematicsResult inverse(const KinematicsRow& row) {
  const LaparoscopeModel model(row.geometry);
  const Vector6d& p = row.given;
  Vector6d q;
  LaparoscopeConfiguration c;
  AssemblyStatus status = model.inverse({p.head<3>(), p[3], p[4], p[5]}, q);
  if (status == AssemblyStatus::ok) status = model.forward(q, c);
  if (status != AssemblyStatus::ok) return refusal(status);
  KinematicsResult result{{}, "", limits_of(c)};
  append(result.values, q);
  append(result.values, c.tool.coordinates());
  return result;
}

KinematicsResult jacobian(const KinematicsRow& row) {
  const LaparoscopeModel model(row.geometry);
  LaparoscopeConfiguration c;
  const AssemblyStatus status = model.forward(row.given, c);
  if (status != AssemblyStatus::ok) return refusal(status);
  KinematicsResult result{{}, "", limits_of(c)};
  append(result.values, model.rates(c).jacobian);
  return result;
}

KinematicsResult gravity(const KinematicsRow& row) {
  const LaparoscopeModel model(row.geometry);
  const LaparoscopeGravity weight(row.geometry, row.masses);
  if (!row.gravity.allFinite()) return {{}, "gx, gy, gz: gravity must be finite, in m/s^2", ""};
  LaparoscopeConfiguration c;
  const AssemblyStatus status = model.forward(row.given, c);
  if (status != AssemblyStatus::ok) return refusal(status);
  KinematicsResult result{{weight.potential(c, row.gravity)}, "", limits_of(c)};
  append(result.values, weight.effort(c, model.rates(c), row.gravity));
  return result;
}

/// The column that an error of the model is about: "geometry: base_radius = …" is about Rb.
std::string with_column(const std::string& error) {
  const auto is_about = [&](const char* group, const char* name) {
    return error.starts_with(fmt::format("{}: {} = ", group, name));
  };
  for (const auto& setting : geometry_columns)
    if (is_about("geometry", setting.name)) return fmt::format("{}: {}", setting.column, error);
  for (const auto& setting : mass_columns)
    if (is_about("masses", setting.name)) return fmt::format("{}: {}", setting.column, error);
  return error;
}

/// Whether `column` may be a slip of the pen for `name`.
bool may_mean(const std::string& column, const std::string& name) {
  return !nearest(name, {column}).empty() && column.find_first_of(name) != std::string::npos;
}

}  // namespace

std::span<const KinematicsQuestion> kinematics_questions() {
  static const std::array<KinematicsQuestion, 4> questions = {{
      {"fk", "Pose of the tool from the actuators' positions", actuators,
       six_dof + pose + matrix("R", 3), false, forward},
      {"ik", "Actuators' positions from the pose of the tool", pose, actuators + six_dof, false,
       inverse},
      {"jacobian", "Jacobian: (velocity of E; angular velocity) = J q'", actuators, matrix("J", 6),
       false, jacobian},
      {"gravity", "Potential energy, and the effort that holds the device's weight", actuators,
       Names{"V", "taug1", "taug2", "taug3", "taug4", "taug5", "taug6"}, true, gravity},
  }};
  return questions;
}

KinematicsTable::KinematicsTable(const KinematicsQuestion& question, std::istream& input)
    : question_(question), csv_(input) {
  find_columns();
}

void KinematicsTable::find_columns() {
  Names missing;
  for (const std::string& name : question_.given) {
    if (const auto column = csv_.column(name)) {
      given_.push_back(*column);
      continue;
    }
    std::string similar;
    for (const std::string& column : csv_.columns())
      if (similar.empty() && column != "id" && may_mean(column, name) &&
          std::count(question_.given.begin(), question_.given.end(), column) == 0)
        similar = fmt::format(" (is it what the header calls {}?)", in_quotes(column));
    missing.push_back(in_quotes(name) + similar);
  }
  if (missing.empty()) return;
  throw CsvError(fmt::format("line {}: the header lacks the column{} {}; {} needs {}", csv_.line(),
                             missing.size() == 1 ? "" : "s", join(missing, ", "), question_.name,
                             join(question_.given, ", ")));
}

std::string KinematicsTable::header() const {
  CsvLine line;
  line.add("id");
  for (const std::string& name : question_.results) line.add(name);
  return line.add("error").add("limits").text();
}

KinematicsRow KinematicsTable::read() const {
  KinematicsRow row{Vector6d::Zero(), {}, {}, standard_gravity};
  for (std::size_t i = 0; i < given_.size(); ++i)
    row.given[static_cast<Eigen::Index>(i)] = csv_.number(given_[i]);
  const auto read_own = [&](const char* name, double& value) {
    const auto column = csv_.column(name);
    if (column && !csv_.text(*column).empty()) value = csv_.number(*column);
  };
  for (const auto& setting : geometry_columns)
    read_own(setting.column, row.geometry.*setting.member);
  if (!question_.needs_masses) return row;
  for (const auto& setting : mass_columns) read_own(setting.column, row.masses.*setting.member);
  for (Eigen::Index i = 0; i < 3; ++i)
    read_own(gravity_columns[static_cast<std::size_t>(i)], row.gravity[i]);
  return row;
}

bool KinematicsTable::next(std::string& line) {
  if (!csv_.next()) return false;
  const KinematicsRow row = read();
  KinematicsResult result;
  try {
    result = question_.answer(row);
  } catch (const std::invalid_argument& error) {
    result.error = with_column(error.what());
  }
  ++rows_;
  if (!result.error.empty())
    result.values.assign(question_.results.size(), std::numeric_limits<double>::quiet_NaN());
  CsvLine out;
  const auto id = csv_.column("id");
  out.add(id ? csv_.text(*id) : fmt::format("{}", rows_));
  for (const double value : result.values) out.add(value);
  line = out.add(result.error).add(result.limits).text();
  return true;
}

}  // namespace trocar::cli
