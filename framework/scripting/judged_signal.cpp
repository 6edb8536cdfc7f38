// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/judged_signal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/scripting/run_columns.hpp"
#include "framework/text.hpp"
#include "framework/text_plot.hpp"

namespace trocar::lua {
namespace {

double quantity_of(const Literal& literal, Judged& judged, const char* what) {
  const auto* number = literal.as<double>();
  if (number != nullptr && (*number == 0.0 || judged.unit.dimension.dimensionless()))
    return *number;
  if (const auto* truth = literal.as<bool>();
      truth != nullptr && judged.unit.dimension.dimensionless())
    return *truth ? 1.0 : 0.0;
  if (const auto* text = literal.as<std::string>()) {
    const Quantity read = parse_quantity(*text);
    if (read.unit.dimension == judged.unit.dimension) {
      judged.unit = read.unit;
      return read.value;
    }
  }
  const std::string symbol = si_symbol(judged.unit.dimension);
  throw std::invalid_argument(
      fmt::format("{} = {}: {} needs {}", what, literal.text(), judged.name,
                  symbol.empty() ? "a number" : fmt::format("{0}, e.g. \"1 {0}\"", symbol)));
}

/// The signal around a row, or all of it.
std::string picture(const Judged& judged, std::size_t row, std::optional<double> level,
                    bool whole) {
  constexpr std::size_t least_around = 60;
  const std::size_t size = judged.values.size();
  const std::size_t around = whole ? size : std::max(least_around, size / 8);
  const std::size_t begin = row > around ? row - around : 0;
  const std::size_t count = std::min(size, row + around + 1) - begin;
  return text_plot(std::span(judged.time).subspan(begin, count),
                   std::span(judged.values).subspan(begin, count),
                   {.unit = judged.unit, .level = level, .marked = judged.time[row]});
}

}  // namespace

void refuse_unknown_options(lua_State* state, int table, const char* method,
                            std::vector<std::string> known) {
  if (lua_isnoneornil(state, table)) return;
  if (!lua_istable(state, table))
    throw std::invalid_argument(
        fmt::format("{}: options are a table, e.g. {{ {} = … }}", method, known.front()));
  known.insert(known.end(), {"from", "to"});
  for (const Key& key : ordered_keys(state, table))
    if (std::find(known.begin(), known.end(), key.text) == known.end())
      throw std::invalid_argument(
          fmt::format("{} has no \"{}\"{}", method, key.text, suggestion(key.text, known)));
}

double time_option(lua_State* state, int table, const char* name, double fallback) {
  return lua_istable(state, table) ? time_field(state, table, name, fallback) : fallback;
}

void cut(lua_State* state, int options, Judged& judged) {
  const double from = time_option(state, options, "from", -endless);
  const double to = time_option(state, options, "to", endless);
  const auto begin = std::lower_bound(judged.time.begin(), judged.time.end(), from - 1e-12);
  const auto end = std::upper_bound(begin, judged.time.end(), to + 1e-12);
  const auto first = begin - judged.time.begin(), last = end - judged.time.begin();
  judged.first = static_cast<std::size_t>(first);
  judged.values = {judged.values.begin() + first, judged.values.begin() + last};
  judged.time = {begin, end};
  if (judged.values.empty())
    throw std::invalid_argument(fmt::format("{} has no row between `from` and `to`", judged.name));
}

Judged judged_signal(lua_State* state, const char* method, int options) {
  const SignalRef& signal = expected_signal(state, method);
  SignalColumns columns = columns_of(signal);
  if (columns.all.size() != 1)
    throw std::invalid_argument(fmt::format(
        "\"{0}\" has {1} numbers: name one of them, e.g. \"{0}.x\", or take its length by :norm()",
        signal.name, columns.all.size()));
  Judged judged{.name = signal.norm ? "norm of " + signal.name : signal.name,
                .values = std::move(columns.all.front()),
                .time = std::move(columns.time),
                .unit = columns.unit};
  cut(state, options, judged);
  return judged;
}

double quantity_at(lua_State* state, int index, Judged& judged, const char* what) {
  return quantity_of(to_literal(state, index), judged, what);
}

std::optional<double> band_option(lua_State* state, int options, Judged& judged, double whole) {
  if (!lua_istable(state, options)) return std::nullopt;
  lua_getfield(state, options, "within");
  const Literal within = to_literal(state, -1);
  lua_pop(state, 1);
  if (within.as<std::monostate>() != nullptr) return std::nullopt;
  if (const auto* text = within.as<std::string>())
    if (const Quantity read = parse_quantity(*text); read.unit.symbol == "%")
      return read.value * std::abs(whole);
  return quantity_of(within, judged, "within");
}

Comparison comparison_at(lua_State* state, int index, const char* method) {
  const std::string text = luaL_checkstring(state, index);
  if (const auto comparison = comparison_named(text)) return *comparison;
  throw std::invalid_argument(
      fmt::format("{}(\"{}\", …): needs one of {}", method, text, join(comparison_names(), "  ")));
}

std::string text_of(double value, const Judged& judged) {
  if (!std::isfinite(value)) return fmt::format("{}", value);
  const double rounded = std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
  return format_quantity(rounded, judged.unit);
}

std::string value_in_row(const Judged& judged, std::size_t row) {
  return fmt::format("{} at {:.6g} s", text_of(judged.values[row], judged), judged.time[row]);
}

std::string rows_text(std::size_t count, const Judged& judged) {
  return fmt::format("{} of {} rows", count, judged.values.size());
}

int fail_signal(lua_State* state, const Judged& judged, std::size_t row,
                const std::string& expected, const std::string& got, std::optional<double> level,
                bool whole) {
  const auto place = static_cast<std::int64_t>(judged.first + row);
  SpecFailure failure;
  failure.expected = judged.name + " " + expected;
  failure.got = fmt::format("{} (tick {})", got, place);
  failure.tick = place;
  failure.plot = picture(judged, row, level, whole);
  return fail(state, std::move(failure));
}

}  // namespace trocar::lua
