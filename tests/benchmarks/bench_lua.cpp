// SPDX-License-Identifier: Apache-2.0
// What a force law in Lua costs inside the loop: a spring-damper wall through LuaLaw, with and
// without its guard, beside the same law called by Lua's own C API with numbers on the stack.
//
//   build/bin/bench_lua [TICKS]      a million by default
//
// The median is of blocks of 100 calls, in turn, so that the clock's own cost does not count; the
// tail is of single calls on a thread of the loop, one clock reading included.
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "framework/clock.hpp"
#include "framework/realtime/loop_thread.hpp"
#include "framework/scripting/law_change.hpp"
#include "framework/scripting/law_ports.hpp"

using namespace trocar;
using namespace trocar::lua;

namespace {

constexpr int block = 100;

constexpr const char* law_text = R"lua(
return trocar.fixture {
  parameters = { plane = { "105 mm" }, stiffness = { "2.2 N/mm" }, damping = { "4 N s/m" } },
  outputs = { depth = "m" },
  step = function(p, at, out)
    local depth = math.max(0, at.position.z - p.plane)
    local load = depth > 0 and math.max(0, p.stiffness * depth + p.damping * at.velocity.z) or 0
    out.depth = depth
    out.force:set(0, 0, -load)
  end,
}
)lua";

constexpr const char* raw_text = R"lua(
return function(x, y, z, vx, vy, vz, plane, stiffness, damping)
  local depth = math.max(0, z - plane)
  local load = depth > 0 and math.max(0, stiffness * depth + damping * vz) or 0
  return depth, 0, 0, -load
end
)lua";

/// Where the tool is at a tick: in and out of the wall.
struct Motion {
  Vector3 position;
  Vector3 velocity;
  void at(int tick) {
    position.z = 0.104 + 1e-5 * (tick % 200);
    velocity.z = 0.01 - 1e-4 * (tick % 200);
  }
};

/// A law with memory for its ports, stepped as its component does.
struct Bound {
  Bound(const std::shared_ptr<const LawFile>& file, const LoopLimits& limits)
      : version(file, std::make_unique<LuaLaw>(*file, limits, 1, memory_of(*file))) {
    change.begin(version, {});
  }
  LawMemory memory_of(const LawFile& file) {
    for (const DeclaredParameter& each : file.parameters) declared.declare(owner, each);
    return {.inputs = {reinterpret_cast<std::byte*>(&motion.position),
                       reinterpret_cast<std::byte*>(&motion.velocity)},
            .outputs = {reinterpret_cast<std::byte*>(&force), reinterpret_cast<std::byte*>(&depth)},
            .parameters = owner.parameters()};
  }
  void step(int tick) {
    motion.at(tick);
    if (!change.step({tick, tick * 1'000'000ll, tick * 1e-3, 1e-3})) {
      fmt::print(stderr, "{}\n", change.law().error());
      std::exit(1);
    }
  }
  Motion motion;
  Vector3 force;
  double depth = 0.0;
  ParameterSet owner;
  DeclaredParameters declared;
  LawVersion version;
  LawChange change;
};

/// The same by hand.
struct Raw {
  Raw() : state(luaL_newstate(), &lua_close) {
    luaL_openlibs(state.get());
    if (luaL_dostring(state.get(), raw_text) != LUA_OK) std::exit(1);
  }
  void step(int tick) {
    lua_State* L = state.get();
    motion.at(tick);
    lua_pushvalue(L, -1);
    for (const double number :
         {motion.position.x, motion.position.y, motion.position.z, motion.velocity.x,
          motion.velocity.y, motion.velocity.z, 0.105, 2200.0, 4.0})
      lua_pushnumber(L, number);
    if (lua_pcall(L, 9, 4, 0) != LUA_OK) std::exit(1);
    depth = lua_tonumber(L, -4);
    force = {lua_tonumber(L, -3), lua_tonumber(L, -2), lua_tonumber(L, -1)};
    lua_pop(L, 4);
  }
  Motion motion;
  Vector3 force;
  double depth = 0.0;
  std::unique_ptr<lua_State, void (*)(lua_State*)> state;
};

template <typename Stepped>
double block_ns(Stepped& stepped, int first) {
  const std::int64_t begin = monotonic_ns();
  for (int i = 0; i < block; ++i) stepped.step(first + i);
  return static_cast<double>(monotonic_ns() - begin) / block;
}

double share(std::vector<double>& values, double part) {
  const auto at = static_cast<std::size_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

}  // namespace

int main(int argc, char** argv) {
  const int ticks = argc > 1 ? std::atoi(argv[1]) : 1'000'000;
  Findings findings;
  const auto file = read_law(LawKind::fixture, "wall.lua", "wall.lua", law_text, findings);
  if (!file) {
    fmt::print(stderr, "{}\n", findings.text());
    return 1;
  }
  Raw raw;
  Bound bare(file, {.guarded = false});
  Bound guarded(file, {.deadline_ns = 200'000'000});
  std::vector<double> of_raw, of_bare, of_guarded, single;
  single.reserve(static_cast<std::size_t>(ticks));
  for (int first = 0; first < ticks; first += block) {
    of_raw.push_back(block_ns(raw, first));
    of_bare.push_back(block_ns(bare, first));
    of_guarded.push_back(block_ns(guarded, first));
  }
  std::int64_t allocations = 0;
  std::size_t heap = 0;
  run_on_loop_thread({.realtime = true}, [&] {
    const auto before = mallinfo2().uordblks;
    for (int tick = 0; tick < ticks; ++tick) {
      const std::int64_t begin = monotonic_ns();
      guarded.step(tick);
      single.push_back(static_cast<double>(monotonic_ns() - begin));
      allocations += guarded.change.law().allocations();
    }
    heap = mallinfo2().uordblks - before;
  });
  const double r = share(of_raw, 0.5), b = share(of_bare, 0.5), g = share(of_guarded, 0.5);
  fmt::print("a spring-wall law in Lua, {} ticks\n", ticks);
  fmt::print("{:<42}{:>8.0f} ns\n", "by the C API, numbers on the stack (median)", r);
  fmt::print("{:<42}{:>8.0f} ns   {:.2f} x   target <= 2.5 x\n",
             "LuaLaw without its guard (median)", b, b / r);
  fmt::print("{:<42}{:>8.0f} ns   {:.2f} x   target <= 4 x\n", "LuaLaw with its guard (median)", g,
             g / r);
  fmt::print("{:<42}{:>8.0f} ns              target <= 1000 ns\n", "the same, single ticks (p99.9)",
             share(single, 0.999));
  fmt::print("{:<42}{:>8}                 target 0\n", "allocations, in all ticks",
             allocations + static_cast<std::int64_t>(heap));
  return 0;
}
