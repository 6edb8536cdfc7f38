// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "framework/scripting/run_columns.hpp"
#include "framework/scripting/run_options.hpp"
#include "framework/scripting/script_context.hpp"
#include "framework/signal_math.hpp"
#include "framework/text.hpp"

namespace trocar::lua {

const RowStore& rows_of(lua_State* state) {
  return *self<RunRef>(state, "run:mean(wall.load)").run->result.rows;
}

SignalColumns columns_of(const SignalRef& signal) {
  const RowStore& rows = *signal.run->result.rows;
  Columns found = columns(rows, signal.name);
  if (signal.norm && found.all.size() > 1) {
    std::vector<double>& norm = found.all.front();
    for (std::size_t row = 0; row < norm.size(); ++row) {
      double squares = 0.0;
      for (const std::vector<double>& column : found.all) squares += column[row] * column[row];
      norm[row] = std::sqrt(squares);
    }
    found.all.resize(1);
  }
  return {std::move(found.all), rows.time(found.group), found.unit};
}

std::string signal_at(lua_State* state, int index) {
  if (const auto* output = get<OutputRef>(state, index))
    return signal_name(context(state).graph(), *output);
  if (const auto* signal = get<SignalRef>(state, index)) return signal->name;
  if (lua_type(state, index) == LUA_TSTRING) return lua_tostring(state, index);
  throw std::invalid_argument(
      fmt::format("a signal is needed, e.g. wall.force.z or \"wall.force.z\","
                  " not {}",
                  luaL_tolstring(state, index, nullptr)));
}

Columns columns(const RowStore& rows, const std::string& name) {
  Columns result;
  std::vector<std::string> known;
  for (const RowSignal& signal : rows.signals()) {
    known.push_back(signal.name);
    if (signal.name != name && !signal.name.starts_with(name + ".")) continue;
    result.all.push_back(rows.column(signal));
    result.group = signal.group;
    result.unit = signal.unit;
  }
  if (result.all.empty())
    throw std::invalid_argument(
        fmt::format("the run has no signal \"{}\"{}", name,
                    nearest(name, known).empty() ? "" : suggestion(name, known)));
  return result;
}

Column scalar(const RowStore& rows, const std::string& name) {
  Columns found = columns(rows, name);
  if (found.all.size() != 1)
    throw std::invalid_argument(fmt::format(
        "\"{}\" has {} numbers: name one of them, e.g. \"{}.x\"", name, found.all.size(), name));
  return {std::move(found.all.front()), found.group};
}

double time_field(lua_State* state, int table, const char* name, double fallback) {
  lua_getfield(state, table, name);
  const Literal literal = to_literal(state, -1);
  lua_pop(state, 1);
  return literal.as<std::monostate>() ? fallback : quantity(literal, "s", name);
}

namespace {

void push_fields(lua_State* state, std::initializer_list<std::pair<const char*, double>> fields) {
  lua_newtable(state);
  for (const auto& [name, value] : fields) {
    lua_pushnumber(state, value);
    lua_setfield(state, -2, name);
  }
}

/// The table that a method of a run takes.
void need_table(lua_State* state, const char* example) {
  if (!lua_istable(state, 2))
    throw std::invalid_argument(std::string("a table is needed, e.g. ") + example);
}

/// run:fit { x = …, y = …, where = bool signal, from = "1 s", to = "2 s" }
int fit(lua_State* state) {
  const RowStore& rows = rows_of(state);
  need_table(state, "run:fit { x = spring.stretch, y = weights.load }");
  const auto field = [&](const char* name) {
    lua_getfield(state, 2, name);
    if (lua_isnil(state, -1))
      throw std::invalid_argument(fmt::format("run:fit needs {} = a signal", name));
    Column column = scalar(rows, signal_at(state, -1));
    lua_pop(state, 1);
    return column;
  };
  const Column x = field("x");
  const Column y = field("y");
  lua_getfield(state, 2, "where");
  const Column chosen = lua_isnil(state, -1)
                            ? Column{std::vector<double>(x.values.size(), 1.0), x.group}
                            : scalar(rows, signal_at(state, -1));
  lua_pop(state, 1);
  if (y.group != x.group || chosen.group != x.group)
    throw std::invalid_argument(
        "run:fit: the signals are of different threads, which have rows of their own; fit what one "
        "of them reads");
  const std::vector<double> time = rows.time(x.group);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double from = time_field(state, 2, "from", -infinity);
  const double to = time_field(state, 2, "to", infinity);
  std::vector<double> px, py;
  for (std::size_t i = 0; i < x.values.size(); ++i) {
    if (chosen.values[i] == 0.0 || time[i] < from || time[i] > to) continue;
    px.push_back(x.values[i]);
    py.push_back(y.values[i]);
  }
  const LineFit line = fit_line(px, py);
  push_fields(state, {{"slope", line.slope},
                      {"offset", line.offset},
                      {"r2", line.r2},
                      {"inverse_slope", line.inverse_slope},
                      {"rms", line.rms},
                      {"count", static_cast<double>(line.count)}});
  return 1;
}

/// run:drift(signal): the farthest that it gets from where it starts.
int drift(lua_State* state) {
  const RowStore& rows = rows_of(state);
  const auto all = columns(rows, signal_at(state, 2)).all;
  if (all.front().empty()) throw std::invalid_argument("the run has no rows");
  double farthest = 0.0;
  for (std::size_t row = 0; row < all.front().size(); ++row) {
    double squares = 0.0;
    for (const std::vector<double>& column : all) {
      const double step = column[row] - column.front();
      squares += step * step;
    }
    farthest = std::max(farthest, std::sqrt(squares));
  }
  lua_pushnumber(state, farthest);
  return 1;
}

template <double SignalSummary::*Field>
int summary(lua_State* state) {
  const RowStore& rows = rows_of(state);  // first: it says what a dot instead of a colon is
  const std::vector<double> values = scalar(rows, signal_at(state, 2)).values;
  lua_pushnumber(state, summarise(values).*Field);
  return 1;
}

/// run:at(signal, "1.5 s"): its value in the last row that is not later.
int value_at(lua_State* state) {
  const RowStore& rows = rows_of(state);
  const Column signal = scalar(rows, signal_at(state, 2));
  const double when = quantity(to_literal(state, 3), "s", "run:at");
  const std::vector<double> time = rows.time(signal.group);
  const auto after = std::upper_bound(time.begin(), time.end(), when + 1e-12);
  if (after == time.begin()) throw std::invalid_argument("the run has no row so early");
  lua_pushnumber(state, signal.values[static_cast<std::size_t>(after - time.begin()) - 1]);
  return 1;
}

/// A list of { component, file, time, trouble }.
void push_reloads(lua_State* state, const RunResult& result) {
  lua_newtable(state);
  for (std::size_t i = 0; i < result.reloads.size(); ++i) {
    const ReloadVerdict& one = result.reloads[i];
    lua_newtable(state);
    for (const auto& [name, text] :
         {std::pair{"component", &one.component}, {"file", &one.file}, {"trouble", &one.trouble}}) {
      lua_pushstring(state, text->c_str());
      lua_setfield(state, -2, name);
    }
    lua_pushnumber(state, one.time);
    lua_setfield(state, -2, "time");
    lua_rawseti(state, -2, static_cast<lua_Integer>(i + 1));
  }
}

/// Whoever looks at the faults has seen them.
void push_faults(lua_State* state, const RunResult& result) {
  context(state).faults_looked_at.insert(&result);
  lua_newtable(state);
  for (std::size_t i = 0; i < result.faults.size(); ++i) {
    lua_pushstring(state, result.faults[i].text().c_str());
    lua_rawseti(state, -2, static_cast<lua_Integer>(i + 1));
  }
}

int result_index(lua_State* state) {
  const SessionRun* run = get<RunRef>(state, 1)->run;
  const RunResult& result = run->result;
  const std::string name = luaL_checkstring(state, 2);
  luaL_getmetafield(state, 1, "__methods");
  lua_getfield(state, -1, name.c_str());
  if (!lua_isnil(state, -1)) return 1;
  if (name == "duration") {
    lua_pushnumber(state, result.duration);
  } else if (name == "ticks") {
    lua_pushinteger(state, result.main().loop.ticks);
  } else if (name == "rate") {
    lua_pushnumber(state, result.main().rate);
  } else if (name == "faults") {
    push_faults(state, result);
  } else if (name == "reloads") {
    push_reloads(state, result);
  } else if (name.find('.') != std::string::npos) {
    columns(*result.rows, name);  // that it is there
    push(state, SignalRef{run, name});
  } else {
    return luaL_error(
        state, "a run has no \"%s\"%s", name.c_str(),
        suggestion(name, {"duration", "ticks", "rate", "faults", "reloads", "fit", "drift", "mean",
                          "rms", "min", "max", "first", "last", "at", "samples", "discard"})
            .c_str());
  }
  return 1;
}

}  // namespace

namespace {

/// signal:norm(): the length of a vector.
int signal_norm(lua_State* state) {
  SignalRef signal = self<SignalRef>(state, "signal:norm()");
  signal.norm = true;
  push(state, std::move(signal));
  return 1;
}

int signal_index(lua_State* state) {
  const std::string name = luaL_checkstring(state, 2);
  if (name != "norm")
    return luaL_error(state, "a signal has no \"%s\": signal:norm() is its length", name.c_str());
  lua_pushcfunction(state, guarded<signal_norm>);
  return 1;
}

}  // namespace

void open_results(lua_State* state) {
  const luaL_Reg result[] = {{"__index", guarded<result_index>}, {nullptr, nullptr}};
  make_metatable<RunRef>(state, result);
  const luaL_Reg signal[] = {{"__index", guarded<signal_index>}, {nullptr, nullptr}};
  make_metatable<SignalRef>(state, signal);
  const luaL_Reg methods[] = {{"fit", guarded<fit>},
                              {"drift", guarded<drift>},
                              {"mean", guarded<summary<&SignalSummary::mean>>},
                              {"rms", guarded<summary<&SignalSummary::rms>>},
                              {"min", guarded<summary<&SignalSummary::min>>},
                              {"max", guarded<summary<&SignalSummary::max>>},
                              {"first", guarded<summary<&SignalSummary::first>>},
                              {"last", guarded<summary<&SignalSummary::last>>},
                              {"at", guarded<value_at>},
                              {"samples", guarded<samples>},
                              {"discard", guarded<discard>},
                              {nullptr, nullptr}};
  luaL_getmetatable(state, Meta<RunRef>::name);
  luaL_newlib(state, methods);
  lua_setfield(state, -2, "__methods");
  lua_pop(state, 1);
}

}  // namespace trocar::lua
