// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/loop_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "framework/scripting/bounded_text.hpp"
#include "framework/scripting/loop_hints.hpp"
#include "framework/scripting/loop_world.hpp"

namespace trocar::lua {
namespace {

constexpr int handler = 1;  // where the message handler stays on the stack
constexpr int calls_within_calls = 16;

// A part of the collector's work looks at some 2,600 values: about 10 us.
constexpr int collector_speed = 40;              // [%] of Lua's usual
constexpr int collector_part = 10;               // 2^10 bytes
constexpr std::int64_t bytes_for_a_part = 2048;  // one more for each so many that a step made

/// Lua calls it where an error is raised: its place is known there, and only there.
int note_place(lua_State* state) {
  static_cast<LoopTrace*>(lua_touserdata(state, lua_upvalueindex(1)))->capture(state);
  return 1;
}

/// "membrane.lua:7: what" and "(vector):7: what" without the place, which the trace knows better.
std::string_view without_place(std::string_view message, std::string_view file) RT_SAFE {
  for (const std::string_view chunk : {file, world_chunk}) {
    if (!message.starts_with(chunk)) continue;
    std::size_t at = chunk.size();
    if (at >= message.size() || message[at] != ':') continue;
    ++at;
    while (at < message.size() && message[at] >= '0' && message[at] <= '9') ++at;
    if (message.substr(at).starts_with(": ")) return message.substr(at + 2);
  }
  return message;
}

/// The line in "membrane.lua:7: what", as the parser says it; 0 where there is none.
int line_in(std::string_view message, std::string_view file) RT_SAFE {
  if (!message.starts_with(file) || message.size() <= file.size() || message[file.size()] != ':')
    return 0;
  int line = 0;
  for (std::size_t i = file.size() + 1; i < message.size(); ++i) {
    if (message[i] < '0' || message[i] > '9') break;
    line = 10 * line + (message[i] - '0');
  }
  return line;
}

}  // namespace

LoopState::LoopState(const LoopLimits& limits, std::string_view file, std::uint64_t seed)
    : guard_(limits), file_(file), state_(lua_newstate(&LoopGuard::allocate, &guard_)) {
  const std::string too_small = fmt::format(
      "memory = {} KiB: a script needs {} KiB for itself alone", limits.memory / 1024, 64);
  if (!state_) throw std::invalid_argument(too_small);
  guard_.watch(lua());
  lua_gc(lua(), LUA_GCSTOP);
  lua_pushinteger(lua(), static_cast<lua_Integer>(seed));
  lua_pushcfunction(lua(), open_loop_world);
  lua_insert(lua(), 1);
  if (lua_pcall(lua(), 1, 0, 0) != LUA_OK)
    throw std::invalid_argument(
        guard_.memory() + 4096 > limits.memory ? too_small : std::string(lua_tostring(lua(), -1)));
  lua_gc(lua(), LUA_GCINC, 0, collector_speed, collector_part);
  lua_pushlightuserdata(lua(), &trace_);
  lua_pushcclosure(lua(), note_place, 1);
}

bool LoopState::run_file(std::string_view text, int results) {
  trace_.count = 0;
  guard_.begin_load();
  const std::string chunk = "@" + file_;
  int status = luaL_loadbufferx(lua(), text.data(), text.size(), chunk.c_str(), "t");
  if (status == LUA_OK) status = lua_pcall(lua(), 0, results, handler);
  return finish(status);
}

void LoopState::settle() {
  lua_gc(lua(), LUA_GCCOLLECT);
  push_world_function(lua(), "warm_up");
  lua_pushinteger(lua(), calls_within_calls);
  lua_pcall(lua(), 1, 0, handler);
}

bool LoopState::call(int arguments, int results) RT_SAFE {
  trace_.count = 0;
  guard_.begin_step();
  return finish(lua_pcall(lua(), arguments, results, handler));
}

bool LoopState::finish(int status) RT_SAFE {
  guard_.end();
  if (status == LUA_OK && guard_.breach() == LoopBreach::none) [[likely]]
    return true;
  if (status == LUA_OK) {  // it broke a limit with its very last instruction
    error_[0] = 0;
    char text[256];
    set_error(0, breach_text(text, sizeof text));
    return false;
  }
  describe_error();
  lua_pop(lua(), 1);
  return false;
}

void LoopState::describe_error() RT_SAFE {
  char text[512];
  if (guard_.raised() || (guard_.breach() != LoopBreach::none && lua_isnil(lua(), -1))) {
    trace_ = guard_.trace();
    return set_error(0, breach_text(text, sizeof text));
  }
  if (lua_type(lua(), -1) != LUA_TSTRING) {
    return set_error(0, print(text, "raised a {}: error(…) takes a text",
                              lua_typename(lua(), lua_type(lua(), -1))));
  }
  const std::string_view message = lua_tostring(lua(), -1);
  const std::string_view what = without_place(message, file_);
  set_error(trace_.count == 0 ? line_in(message, file_) : 0,
            print(text, "{}{}", what, hint_for(what)));
}

std::string_view LoopState::breach_text(char* buffer, std::size_t size) const RT_SAFE {
  const LoopLimits& limits = guard_.limits();
  const std::span<char> to(buffer, size);
  switch (guard_.breach()) {
    case LoopBreach::instructions:
      return print(to,
                   "took more than its {} instructions: shorten the loop, or raise "
                   "\"instructions\"",
                   guard_.budget());
    case LoopBreach::time:
      return print(to, "took longer than its {} us: shorten it, or raise \"deadline\"",
                   limits.deadline_ns / 1000);
    case LoopBreach::memory:
      return print(to,
                   "holds more than its {} KiB: keep what it makes within bounds, reuse "
                   "tables, or raise \"memory\"",
                   limits.memory / 1024);
    case LoopBreach::block:
      return print(to,
                   "needs a table, or a stack, of more than {} KiB in one piece: keep it "
                   "short, or raise \"memory\", of which a piece is at most a sixteenth",
                   guard_.largest_block() / 1024);
    case LoopBreach::text:
      return print(to, "makes a text of more than {} bytes: keep it short",
                   LoopGuard::longest_text);
    case LoopBreach::allocation:
      return print(to,
                   "allocates memory, which strict mode refuses: use set, add, scale and "
                   "the like on vectors of its state, or leave \"strict\" out");
    case LoopBreach::none:
      break;
  }
  return {};
}

void LoopState::set_error(int line, std::string_view message) RT_SAFE {
  if (line == 0) line = trace_.count > 0 ? trace_.frames[0].line : spare_line_;
  std::size_t size = 0;
  const auto room = [&] { return std::span(error_).first(error_.size() - 1).subspan(size); };
  size += print(room(), "{}", file_).size();
  if (line > 0) size += print(room(), ":{}", line).size();
  size += print(room(), ": {}", message).size();
  for (std::size_t i = 1; i < trace_.count; ++i)
    size += print(room(), "{} line {}", i == 1 ? "; called at" : ",", trace_.frames[i].line).size();
  error_[size] = 0;
}

void LoopState::collect() RT_SAFE {
  uncollected_ += static_cast<std::size_t>(guard_.allocated());
  if (!collecting_ && uncollected_ < guard_.limits().memory / 8) return;
  if (!collecting_) uncollected_ = 0;
  // Where a part ends depends on the order of hashed names, which Lua makes different in each run.
  if (guard_.limits().whole_cycles) {
    lua_gc(lua(), LUA_GCCOLLECT);
    return;
  }
  collecting_ = true;
  for (std::int64_t done = 0; collecting_ && done <= guard_.allocated(); done += bytes_for_a_part)
    collecting_ = lua_gc(lua(), LUA_GCSTEP, 0) == 0;
}

}  // namespace trocar::lua
