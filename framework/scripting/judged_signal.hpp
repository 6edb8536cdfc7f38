// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "framework/scripting/spec_context.hpp"
#include "framework/signal_checks.hpp"
#include "framework/units.hpp"

/// @file
/// What the methods of expect(signal) share.

namespace trocar::lua {

constexpr double endless = std::numeric_limits<double>::infinity();  // [s]

/// The rows of a signal that a method judges: those between its `from` and `to`.
struct Judged {
  std::string name;
  std::vector<double> values{};
  std::vector<double> time{};  // [s]
  Unit unit{};                 // as the script writes its quantities, else the signal's
  std::size_t first = 0;       // row of the signal
};

/// @param known options besides `from` and `to`
/// @throw std::invalid_argument for another one
void refuse_unknown_options(lua_State* state, int table, const char* method,
                            std::vector<std::string> known);
/// An option's time [s], or `fallback`.
double time_option(lua_State* state, int table, const char* name, double fallback);
/// The signal that expect() was given.
/// @throw std::invalid_argument for one of several numbers
Judged judged_signal(lua_State* state, const char* method, int options);
/// Only the rows from `from` to `to`.
void cut(lua_State* state, int options, Judged& judged);
/// A quantity of the signal's dimension; bare numbers where that is none, and for zero. Messages
/// then use the script's unit.
double quantity_at(lua_State* state, int index, Judged& judged, const char* what);
/// A band around a target: `within = "0.1 N"`, or in % of `whole`.
std::optional<double> band_option(lua_State* state, int options, Judged& judged, double whole);
Comparison comparison_at(lua_State* state, int index, const char* method);

std::string text_of(double value, const Judged& judged);
/// "0.35 N at 0.412 s"
std::string value_in_row(const Judged& judged, std::size_t row);
/// "38 of 2000 rows"
std::string rows_text(std::size_t count, const Judged& judged);
/// Ends the test.
/// @param level a line of the plot
/// @param whole the plot shows all rows, not only those around `row`
int fail_signal(lua_State* state, const Judged& judged, std::size_t row,
                const std::string& expected, const std::string& got, std::optional<double> level,
                bool whole = false);

}  // namespace trocar::lua
