// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/loop_guard.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "framework/clock.hpp"

namespace trocar::lua {
namespace {

constexpr std::size_t text_header = 32;  // [bytes] that Lua adds to a text, at most

/// Doubling a block of the largest size, twice, still fits.
std::size_t reserve(const LoopLimits& limits) {
  return limits.memory / 4;
}

}  // namespace

void LoopTrace::capture(lua_State* state) RT_SAFE {
  count = 0;
  lua_Debug at;
  for (int level = 0; count < frames.size() && lua_getstack(state, level, &at) != 0; ++level) {
    lua_getinfo(state, "Sln", &at);
    if (at.source[0] != '@' || at.currentline <= 0) continue;  // not of the script's file
    Frame& frame = frames[count++];
    frame.line = at.currentline;
    const std::string_view name = at.name == nullptr ? "" : at.name;
    const std::size_t size = std::min(name.size(), sizeof frame.function - 1);
    std::memcpy(frame.function, name.data(), size);
    frame.function[size] = 0;
  }
}

LoopGuard::LoopGuard(const LoopLimits& limits)
    : limits_(limits), pool_(limits.memory + reserve(limits)) {}

void LoopGuard::begin(std::int64_t instructions, bool step) RT_SAFE {
  left_ = instructions;
  last_ns_ = 0;
  stepping_ = step;
  allocations_ = allocated_ = 0;
  breach_ = LoopBreach::none;
  raised_ = false;
  if (!limits_.guarded) return;
  armed_ = true;
  lua_sethook(state_, hook, LUA_MASKCOUNT, interval);
}

void LoopGuard::doom(LoopBreach breach) RT_SAFE {
  if (breach_ != LoopBreach::none) return;
  breach_ = breach;
  lua_sethook(state_, hook, LUA_MASKCOUNT, 1);
}

void LoopGuard::charge(std::int64_t instructions) RT_SAFE {
  left_ -= instructions;
  if (left_ < 0) doom(LoopBreach::instructions);
}

bool LoopGuard::is_late() RT_SAFE {
  const std::int64_t now = monotonic_ns();
  if (last_ns_ == 0) last_ns_ = now + limits_.deadline_ns;
  return now > last_ns_;
}

/// Behind the last instruction.
void LoopGuard::look_once_more() RT_SAFE {
  if (breach_ == LoopBreach::none && is_late()) breach_ = LoopBreach::time;
}

void LoopGuard::hook(lua_State* state, lua_Debug*) {
  void* guard = nullptr;
  lua_getallocf(state, &guard);
  static_cast<LoopGuard*>(guard)->look(state);
}

void LoopGuard::look(lua_State* state) {
  if (!armed_) return;
  if (breach_ == LoopBreach::none) {
    left_ -= interval;
    if (left_ <= 0)
      doom(LoopBreach::instructions);
    else if (stepping_ && limits_.deadline_ns > 0 && is_late())
      doom(LoopBreach::time);
    if (breach_ == LoopBreach::none) return;
  }
  if (!raised_) trace_.capture(state);
  raised_ = true;
  lua_pushnil(state);
  lua_error(state);
}

/// What the script asks for, before it gets it.
void LoopGuard::account(const void* block, std::size_t old_size, std::size_t size) RT_SAFE {
  if (block == nullptr) {
    ++allocations_;
    allocated_ += static_cast<std::int64_t>(size);
    if (armed_ && old_size == LUA_TSTRING && size > longest_text + text_header)
      doom(LoopBreach::text);
  } else if (size > old_size) {
    ++allocations_;
    allocated_ += static_cast<std::int64_t>(size - old_size);
  } else {
    return;
  }
  if (!armed_) return;
  if (size > largest_block()) doom(LoopBreach::block);
  if (held_ + cost(size) > limits_.memory) doom(LoopBreach::memory);
  if (limits_.strict && stepping_) doom(LoopBreach::allocation);
}

void* LoopGuard::allocate(void* guard, void* block, std::size_t old_size,
                          std::size_t size) RT_SAFE {
  auto& self = *static_cast<LoopGuard*>(guard);
  const std::size_t before = block == nullptr ? 0 : cost(old_size);
  if (size == 0) {
    self.pool_.give_back(block);
    self.held_ -= before;
    return nullptr;
  }
  self.account(block, old_size, size);
  void* given = block == nullptr ? self.pool_.take(size) : self.pool_.resize(block, size);
  if (given != nullptr) self.held_ += cost(size) - before;
  return given;
}

}  // namespace trocar::lua
