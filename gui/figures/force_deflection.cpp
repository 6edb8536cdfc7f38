// SPDX-License-Identifier: Apache-2.0
#include "gui/figures/force_deflection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "framework/text.hpp"

namespace trocar::gui {
namespace {

using Json = nlohmann::json;

bool are_numbers(const Json& list) {
  return list.is_array() &&
         std::all_of(list.begin(), list.end(), [](const Json& one) { return one.is_number(); });
}

bool has_readings(const Json& row) {
  return row.contains("x") && row.contains("force") && are_numbers(row["x"]) &&
         are_numbers(row["force"]);
}

std::string text_of(const Json& value) {
  if (value.is_number()) return fmt::format("{:g}", value.get<double>());
  return value.is_string() ? value.get<std::string>() : value.dump();
}

bool matches(const Json& value, const std::string& wanted) {
  if (!value.is_number()) return text_of(value) == wanted;
  double number = 0.0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
  return error == std::errc() && end == wanted.data() + wanted.size() &&
         value.get<double>() == number;
}

bool matches(const Json& row, const RowFilter& filter) {
  return std::all_of(filter.begin(), filter.end(), [&](const auto& one) {
    return row.contains(one.first) && matches(row[one.first], one.second);
  });
}

double number_in(const Json& row, const char* key) {
  const auto found = row.find(key);
  return found != row.end() && found->is_number() ? found->get<double>()
                                                  : std::numeric_limits<double>::quiet_NaN();
}

std::string label_of(const Json& row, std::size_t number) {
  std::vector<std::string> parts;
  if (row.contains("axis")) parts.push_back(text_of(row["axis"]));
  if (const double desired = number_in(row, "desired"); std::isfinite(desired))
    parts.push_back(fmt::format("{:g} N/mm", 1e-3 * desired));
  return parts.empty() ? std::to_string(number) : join(parts, ", ");
}

ForceDeflection fitted(const Json& row, std::size_t number) {
  ForceDeflection curve{.label = label_of(row, number),
                        .deflection = row["x"].get<std::vector<double>>(),
                        .force = row["force"].get<std::vector<double>>(),
                        .residual = {}};
  const std::vector<std::vector<double>> columns = {
      curve.deflection, std::vector<double>(curve.deflection.size(), 1.0)};
  LinearFit fit;
  try {
    fit = fit_linear(columns, curve.force);
  } catch (const std::invalid_argument& error) {
    throw FigureError(curve.label + ": " + error.what());
  }
  curve.slope = fit.solution[0];
  curve.slope_error = fit.errors[0];
  curve.intercept = fit.solution[1];
  curve.rms = fit.rms;
  curve.r2 = fit.r2;
  curve.reported = number_in(row, "slope");
  for (std::size_t i = 0; i < curve.force.size(); ++i)
    curve.residual.push_back(curve.force[i] - curve.slope * curve.deflection[i] - curve.intercept);
  return curve;
}

/// What may differ between the curves of one figure.
bool is_of_a_curve(const std::string& key, const Json& value) {
  return key == "axis" || key == "desired" ||
         !(value.is_boolean() || value.is_string() || key == "seed");
}

}  // namespace

ForceDeflections force_deflections(const ResultFile& file, const RowFilter& filter) {
  ForceDeflections all{.source = "", .curves = {}, .shown = filter};
  const Json* rows = nullptr;
  for (const auto& [name, some] : file.published())
    if (rows == nullptr && std::any_of(some.begin(), some.end(), has_readings)) {
      all.source = name;
      rows = &some;
    }
  if (rows == nullptr)
    throw FigureError(
        "force-deflection needs published rows with the lists x [m] and force [N], as "
        "scripts/experiments/table1.lua publishes them; this is " +
        file.contents());
  all.rows = rows->size();
  bool found = false;
  for (const Json& row : *rows) {
    if (!has_readings(row) || !matches(row, all.shown)) continue;
    if (!found)
      for (const auto& [key, value] : row.items())
        if (!is_of_a_curve(key, value)) all.shown.try_emplace(key, text_of(value));
    found = true;
    if (all.curves.size() == most_curves)
      throw FigureError(fmt::format("more than {} rows of {} fit: choose some by --where KEY=VALUE",
                                    most_curves, all.source));
    all.curves.push_back(fitted(row, all.curves.size() + 1));
  }
  if (!found) throw FigureError("no row of " + all.source + " fits what --where asks for");
  return all;
}

std::string fit_text(const ForceDeflection& curve) {
  return fmt::format(
      "{}: slope {:.3f} ± {:.3f} N/mm, intercept {:.3f} N, R² {:.5f}, residual {:.3f} N RMS, {} "
      "readings",
      curve.label, 1e-3 * curve.slope, 1e-3 * curve.slope_error, curve.intercept, curve.r2,
      curve.rms, curve.force.size());
}

}  // namespace trocar::gui
