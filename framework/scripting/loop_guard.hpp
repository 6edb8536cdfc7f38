// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <lua.hpp>

#include "framework/realtime/rt_safe.hpp"
#include "framework/scripting/loop_pool.hpp"

namespace trocar::lua {

/// What a script in the loop may use. Instructions and bytes are counted alike in every run, so
/// that a run in virtual time ends at the same place each time; time is looked at in real time
/// only.
struct LoopLimits {
  std::size_t memory = 512 * 1024;             // [bytes] of everything that the script holds
  std::int64_t instructions = 10'000;          // of one step
  std::int64_t load_instructions = 1'000'000;  // of running the file, before the first tick
  std::int64_t deadline_ns = 0;                // of one step; 0: time is not looked at
  bool strict = false;                         // a step that allocates is an error
  bool whole_cycles = false;  // the collector does a cycle at once: alike in every run
  bool guarded = true;        // false: to measure what the guard costs
};

/// Why a script was ended by force.
enum class LoopBreach { none, instructions, time, memory, block, text, allocation };

/// Where a script was: the lines of its file that were being executed, innermost first.
struct LoopTrace {
  struct Frame {
    int line = 0;
    char function[24] = "";
  };
  std::array<Frame, 6> frames{};
  std::size_t count = 0;

  void capture(lua_State* state) RT_SAFE;
};

/// Watches over a script while it runs: counts its instructions, looks at the clock, and hands out
/// its memory. It looks every 100 instructions, the clock for the first time then: so an ordinary
/// law pays for no clock, and is not blamed for what the machine does in between. A breach is
/// latched and raised as an error at the very next instruction, and again at each one after, so
/// that no pcall lets the script go on.
///
/// Lua's own answer to a lack of memory is a collection of all of it, in the middle of the step,
/// and an error without a place. So there is a reserve: what goes beyond a limit is still served
/// from it, and the next instruction raises the error where it stands.
class LoopGuard {
 public:
  static constexpr int interval = 100;               // [instructions] between two looks
  static constexpr std::size_t longest_text = 1024;  // [bytes]

  explicit LoopGuard(const LoopLimits& limits);

  /// Of a new state: all its memory comes from here.
  static void* allocate(void* guard, void* block, std::size_t old_size, std::size_t size) RT_SAFE;
  void watch(lua_State* state) { state_ = state; }

  /// From now until end() the file is run, or a step.
  void begin_load() RT_SAFE { begin(limits_.load_instructions, false); }
  void begin_step() RT_SAFE { begin(limits_.instructions, true); }
  void end() RT_SAFE {
    if (last_ns_ != 0) look_once_more();
    armed_ = false;
  }
  /// A function in C is about to do as much as this many instructions.
  void charge(std::int64_t instructions) RT_SAFE;

  LoopBreach breach() const RT_SAFE { return breach_; }
  /// The script met its end by force, rather than by an error of its own.
  bool raised() const RT_SAFE { return raised_; }
  const LoopTrace& trace() const RT_SAFE { return trace_; }
  const LoopLimits& limits() const RT_SAFE { return limits_; }
  /// That the file or the step, whichever ran last, might take.
  std::int64_t budget() const RT_SAFE {
    return stepping_ ? limits_.instructions : limits_.load_instructions;
  }
  std::size_t largest_block() const RT_SAFE { return limits_.memory / 16; }

  /// [bytes] that the script holds, each block with its header. What the pool takes beyond that
  /// depends on where its blocks happen to lie.
  std::size_t memory() const RT_SAFE { return held_; }
  std::int64_t allocations() const RT_SAFE { return allocations_; }  // since begin()
  std::int64_t allocated() const RT_SAFE { return allocated_; }      // [bytes] since begin()

 private:
  void begin(std::int64_t instructions, bool step) RT_SAFE;
  static void hook(lua_State* state, lua_Debug* where);
  void look(lua_State* state);
  bool is_late() RT_SAFE;
  void look_once_more() RT_SAFE;
  static constexpr std::size_t cost(std::size_t size) RT_SAFE { return (size + 31) / 16 * 16; }
  void account(const void* block, std::size_t old_size, std::size_t size) RT_SAFE;
  void doom(LoopBreach breach) RT_SAFE;

  LoopLimits limits_;
  LoopPool pool_;
  std::size_t held_ = 0;  // [bytes]
  lua_State* state_ = nullptr;
  std::int64_t left_ = 0;     // [instructions]
  std::int64_t last_ns_ = 0;  // when it has to be over; 0 before the first look
  std::int64_t allocations_ = 0;
  std::int64_t allocated_ = 0;
  bool armed_ = false;
  bool stepping_ = false;
  bool raised_ = false;
  LoopBreach breach_ = LoopBreach::none;
  LoopTrace trace_;
};

}  // namespace trocar::lua
