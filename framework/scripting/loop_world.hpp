// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <lua.hpp>
#include <string_view>

namespace trocar::lua {

/// How errors call the functions that the world has in Lua.
constexpr std::string_view world_chunk = "(trocar)";

/// Opens what a script in the loop can see, called in protected mode with a seed of random numbers.
/// Nothing of it reaches a file, another thread or the state's inside, and nothing takes longer
/// than the guard can bear between two of its looks:
///
/// - math; of string what needs no pattern; of table what is written in Lua itself, so that its
///   instructions count; pcall, error, assert, select, ipairs, type, tonumber;
/// - pairs in an order that does not depend on addresses, tostring without addresses;
/// - vec, and what vectors can do (loop_vectors.cpp);
/// - no coroutines, no metatables, no load, no debug, no xpcall, no collector.
///
/// A name that is not there is an error that says so, with the nearest right one or the cure.
/// Assigning to a global is one, too.
///
/// The registry's "trocar" is then a table of functions for the framework's use:
///   record(), vector(read_only), take(own, given, name), guard(table, owner, known, …)
int open_loop_world(lua_State* state);

/// Pushes the function of that name out of the registry's table.
void push_world_function(lua_State* state, const char* name);

/// The part in Lua: text of a chunk.
std::string_view loop_library_text();
std::string_view loop_vectors_text();

}  // namespace trocar::lua
