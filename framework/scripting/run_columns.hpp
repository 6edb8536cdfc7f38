// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "framework/scripting/script_context.hpp"

/// @file
/// What the methods of a run's result share: its signals as columns of numbers.

namespace trocar::lua {

/// The rows of the run that a method was called on. @throw std::invalid_argument without a colon
const RowStore& rows_of(lua_State* state);

/// A signal's name, from an output or a string.
std::string signal_at(lua_State* state, int index);

/// The numbers of a signal, in each row of its thread: one column for a scalar, several for a
/// vector or a pose.
struct Columns {
  std::vector<std::vector<double>> all;
  std::size_t group = 0;  // of which thread
  Unit unit{};            // of the last
};
/// @throw std::invalid_argument for a signal that the run does not have, with the nearest one
Columns columns(const RowStore& rows, const std::string& name);

/// A signal that is one number in each row.
struct Column {
  std::vector<double> values;
  std::size_t group = 0;  // of which thread
};
/// @throw std::invalid_argument for a signal of several numbers
Column scalar(const RowStore& rows, const std::string& name);

/// A signal of a run with the times of its rows [s].
struct SignalColumns {
  std::vector<std::vector<double>> all;
  std::vector<double> time;
  Unit unit{};
};
SignalColumns columns_of(const SignalRef& signal);

/// A time in a field of a table, or `fallback` where there is none [s].
double time_field(lua_State* state, int table, const char* name, double fallback);

/// run:samples(signal, { from = …, to = …, every = n, where = bool signal })
int samples(lua_State* state);
/// run:discard(): gives its rows back; runs that follow each other would fill the disk.
int discard(lua_State* state);

}  // namespace trocar::lua
