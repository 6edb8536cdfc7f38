// SPDX-License-Identifier: Apache-2.0
#include "cli/kinematics_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "cli/kinematics_columns.hpp"
#include "cli/output.hpp"
#include "components/kinematics/laparoscope_gravity.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

/// The column that an error of the model is about: "geometry: base_radius = …" is about Rb.
std::string with_column(const std::string& error) {
  const auto is_about = [&](const char* group, const char* name) {
    return error.starts_with(fmt::format("{}: {} = ", group, name));
  };
  for (const auto& setting : geometry_columns)
    if (is_about("geometry", setting.name)) return fmt::format("{}: {}", setting.column, error);
  for (const auto& setting : mass_columns)
    if (is_about("masses", setting.name)) return fmt::format("{}: {}", setting.column, error);
  for (const auto& setting : inertia_columns)
    if (is_about("masses", setting.name)) return fmt::format("{}: {}", setting.column, error);
  return error;
}

/// Whether `column` may be a slip of the pen for `name`.
bool may_mean(const std::string& column, const std::string& name) {
  return !nearest(name, {column}).empty() && column.find_first_of(name) != std::string::npos;
}

}  // namespace

KinematicsTable::KinematicsTable(const KinematicsQuestion& question, std::istream& input)
    : question_(question), csv_(input) {
  find_columns();
}

void KinematicsTable::find_columns() {
  std::vector<std::string> missing;
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
  KinematicsRow row{.given = Vector6d::Zero(),
                    .velocity = Vector6d::Zero(),
                    .geometry = {},
                    .masses = {},
                    .gravity = standard_gravity,
                    .effort = Vector6d::Zero(),
                    .wrench = Vector6d::Zero()};
  for (std::size_t i = 0; i < given_.size(); ++i)
    (i < 6 ? row.given : row.velocity)[static_cast<Eigen::Index>(i % 6)] = csv_.number(given_[i]);
  const auto read_own = [&](const char* name, double& value) {
    const auto column = csv_.column(name);
    if (column && !csv_.text(*column).empty()) value = csv_.number(*column);
  };
  const auto read_vector = [&](const auto& names, auto& vector) {
    for (std::size_t i = 0; i < names.size(); ++i)
      read_own(names[i], vector[static_cast<Eigen::Index>(i)]);
  };
  for (const auto& setting : geometry_columns)
    read_own(setting.column, row.geometry.*setting.member);
  if (question_.own == KinematicsOwn::geometry) return row;
  for (const auto& setting : mass_columns) read_own(setting.column, row.masses.*setting.member);
  read_vector(gravity_columns, row.gravity);
  if (question_.own == KinematicsOwn::weight) return row;
  for (const auto& setting : inertia_columns) read_own(setting.column, row.masses.*setting.member);
  read_vector(effort_columns, row.effort);
  read_vector(wrench_columns, row.wrench);
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
