// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/scripting/judged_signal.hpp"
#include "framework/scripting/run_columns.hpp"
#include "framework/signal_checks.hpp"

namespace trocar::lua {
namespace {

constexpr double settling_share = 0.02;  // of the way: the usual band of control engineering

/// expect(signal):always("<=", "5 N", { from = "1 s", to = "2 s" })
int always_method(lua_State* state) {
  refuse_unknown_options(state, 4, "always", {});
  Judged judged = judged_signal(state, "always", 4);
  const Comparison comparison = comparison_at(state, 2, "always");
  const double bound = quantity_at(state, 3, judged, "always");
  const SignalVerdict verdict = always(judged.values, comparison, bound);
  if (verdict.holds) return 0;
  return fail_signal(state, judged, verdict.row,
                     fmt::format("{} {}, always", lua_tostring(state, 2), text_of(bound, judged)),
                     fmt::format("{}, and so in {}", value_in_row(judged, verdict.row),
                                 rows_text(verdict.count, judged)),
                     bound);
}

/// expect(signal):eventually(">", "5 N", { before = "1 s" })
int eventually_method(lua_State* state) {
  refuse_unknown_options(state, 4, "eventually", {"before"});
  Judged judged = judged_signal(state, "eventually", 4);
  const Comparison comparison = comparison_at(state, 2, "eventually");
  const double bound = quantity_at(state, 3, judged, "eventually");
  const double before = time_option(state, 4, "before", endless);
  const SignalVerdict verdict = eventually(judged.values, comparison, bound);
  if (verdict.holds && judged.time[verdict.row] <= before) return 0;
  const std::string when = std::isfinite(before) ? fmt::format(" before {:g} s", before) : "";
  return fail_signal(
      state, judged, verdict.row,
      fmt::format("{} {}, some time{}", lua_tostring(state, 2), text_of(bound, judged), when),
      (verdict.holds ? "not until " : "at most near it: ") + value_in_row(judged, verdict.row),
      bound, true);
}

/// expect(signal):within("1 N", "2 N")
int within_method(lua_State* state) {
  refuse_unknown_options(state, 4, "within", {});
  Judged judged = judged_signal(state, "within", 4);
  const double low = quantity_at(state, 2, judged, "within");
  const double high = quantity_at(state, 3, judged, "within");
  if (low > high)
    throw std::invalid_argument(fmt::format("within({}, {}): the lower bound comes first",
                                            text_of(low, judged), text_of(high, judged)));
  const SignalVerdict above = always(judged.values, Comparison::less_or_equal, high);
  const SignalVerdict below = always(judged.values, Comparison::greater_or_equal, low);
  if (above.holds && below.holds) return 0;
  const bool first_above = !above.holds && (below.holds || above.row <= below.row);
  const std::size_t row = first_above ? above.row : below.row;
  return fail_signal(state, judged, row,
                     fmt::format("within {} and {}", text_of(low, judged), text_of(high, judged)),
                     fmt::format("{}, and outside in {}", value_in_row(judged, row),
                                 rows_text(above.count + below.count, judged)),
                     first_above ? high : low);
}

/// expect(signal):settles("0 N", { before = "1.5 s", within = "0.1 N" })
int settles_method(lua_State* state) {
  refuse_unknown_options(state, 3, "settles", {"before", "within"});
  Judged judged = judged_signal(state, "settles", 3);
  const double target = quantity_at(state, 2, judged, "settles");
  double farthest = 0.0;
  for (const double value : judged.values) farthest = std::max(farthest, std::abs(value - target));
  const double band = band_option(state, 3, judged, target).value_or(settling_share * farthest);
  const double before = time_option(state, 3, "before", endless);
  const SignalVerdict verdict = settles(judged.values, target, band);
  if (verdict.holds && judged.time[verdict.row] <= before) return 0;
  const std::string when = std::isfinite(before) ? fmt::format(" before {:g} s", before) : "";
  return fail_signal(
      state, judged, verdict.row,
      fmt::format("settles at {} ± {}{}", text_of(target, judged), text_of(band, judged), when),
      verdict.holds ? fmt::format("there from {:.6g} s on", judged.time[verdict.row])
                    : "at the end " + value_in_row(judged, verdict.row),
      target, true);
}

/// expect(signal):peaks("-4 N", { within = "0.1 N" })
int peaks_method(lua_State* state) {
  refuse_unknown_options(state, 3, "peaks", {"within"});
  Judged judged = judged_signal(state, "peaks", 3);
  const double target = quantity_at(state, 2, judged, "peaks");
  const auto band = band_option(state, 3, judged, target);
  if (!band)
    throw std::invalid_argument("peaks needs within, e.g. peaks(\"4 N\", { within = \"0.1 N\" })");
  const SignalVerdict verdict = peaks(judged.values, target, *band);
  if (verdict.holds) return 0;
  return fail_signal(
      state, judged, verdict.row,
      fmt::format("peaks at {} ± {}", text_of(target, judged), text_of(*band, judged)),
      value_in_row(judged, verdict.row), target, true);
}

std::string text_option(lua_State* state, int options, const char* name) {
  if (!lua_istable(state, options)) return "";
  lua_getfield(state, options, name);
  std::string text = lua_isnil(state, -1) ? "" : luaL_checkstring(state, -1);
  lua_pop(state, 1);
  return text;
}

/// `times`: any number where it is not given.
std::optional<std::size_t> times_option(lua_State* state, int options) {
  if (!lua_istable(state, options)) return std::nullopt;
  const int type = lua_getfield(state, options, "times");
  const lua_Integer times = lua_tointeger(state, -1);
  const bool whole = lua_isinteger(state, -1) != 0 && times >= 0;
  lua_pop(state, 1);
  if (type == LUA_TNIL) return std::nullopt;
  if (!whole) throw std::invalid_argument("crosses: times needs a whole number, 0 or more");
  return static_cast<std::size_t>(times);
}

/// expect(signal):crosses("1 N", { times = 2, way = "up", before = "1 s" })
int crosses_method(lua_State* state) {
  refuse_unknown_options(state, 3, "crosses", {"times", "way", "before"});
  Judged judged = judged_signal(state, "crosses", 3);
  const double level = quantity_at(state, 2, judged, "crosses");
  const std::string way = text_option(state, 3, "way");
  if (!way.empty() && way != "up" && way != "down")
    throw std::invalid_argument(
        fmt::format("crosses: way = \"{}\": needs \"up\" or \"down\"", way));
  const std::optional<std::size_t> times = times_option(state, 3);
  const double before = time_option(state, 3, "before", endless);
  std::vector<LevelCrossing> found = crossings(judged.values, level);
  std::erase_if(found, [&](const LevelCrossing& crossing) {
    return judged.time[crossing.row] > before || (!way.empty() && crossing.up != (way == "up"));
  });
  if (times ? found.size() == *times : !found.empty()) return 0;
  std::string got = found.empty() ? "never" : fmt::format("{} times, at", found.size());
  constexpr std::size_t most_shown = 8;
  for (std::size_t i = 0; i < std::min(found.size(), most_shown); ++i)
    got += fmt::format("{} {:.6g} s", i == 0 ? "" : ",", judged.time[found[i].row]);
  if (found.size() > most_shown) got += ", …";
  return fail_signal(
      state, judged, found.empty() ? judged.values.size() - 1 : found.back().row,
      fmt::format("crosses {}{}{}{}", text_of(level, judged), way.empty() ? "" : " " + way,
                  times ? fmt::format(" {} times", *times) : "",
                  std::isfinite(before) ? fmt::format(" before {:g} s", before) : ""),
      got, level, true);
}

/// expect(force):energy("<=", "1 mJ", { velocity = run["laparoscope.tool.tip.velocity"] })
int energy_method(lua_State* state) {
  refuse_unknown_options(state, 4, "energy", {"velocity"});
  const SignalRef& force = expected_signal(state, "energy");
  lua_settop(state, 4);
  if (!lua_istable(state, 4) || lua_getfield(state, 4, "velocity") == LUA_TNIL)
    throw std::invalid_argument("energy needs velocity = a signal of the same point");
  const auto* velocity = get<SignalRef>(state, -1);
  if (velocity == nullptr)
    throw std::invalid_argument("energy: velocity needs a signal, e.g. run[\"tool.tip.velocity\"]");
  SignalColumns along = columns_of(force);
  Judged judged{.name = fmt::format("energy given by {}", force.name),
                .values = work(along.all, columns_of(*velocity).all, along.time),
                .time = std::move(along.time),
                .unit = parse_unit("J")};
  cut(state, 4, judged);
  const Comparison comparison = comparison_at(state, 2, "energy");
  const double bound = quantity_at(state, 3, judged, "energy");
  const SignalVerdict verdict = always(judged.values, comparison, bound);
  if (verdict.holds) return 0;
  return fail_signal(state, judged, verdict.row,
                     fmt::format("{} {}, always", lua_tostring(state, 2), text_of(bound, judged)),
                     fmt::format("{}, and so in {}", value_in_row(judged, verdict.row),
                                 rows_text(verdict.count, judged)),
                     bound);
}

}  // namespace

const luaL_Reg signal_expectations[] = {
    {"always", guarded<always_method>}, {"eventually", guarded<eventually_method>},
    {"within", guarded<within_method>}, {"settles", guarded<settles_method>},
    {"peaks", guarded<peaks_method>},   {"crosses", guarded<crosses_method>},
    {"energy", guarded<energy_method>}, {nullptr, nullptr}};

}  // namespace trocar::lua
