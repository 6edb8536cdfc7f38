-- Transparency: what is felt of a device that renders nothing.
--
-- Drag and apparent mass. A carriage clamps the tool at its tip and 100 mm behind it, so that it
-- cannot tilt, by springs of 20 N/mm with 30 N s/m each, and moves it to and fro at a constant
-- speed; load cells in the clamps tell the force. Over the parts of constant speed
--
--   F = m a + drag sgn(v) + F_0
--
-- where a, the tip's acceleration, is what rings after the turns. The apparent mass is that of a
-- chirp of 3 mm from 2 to 8 Hz with F = m a + b v + drag sgn(v) + F_0.
--
-- Gravity drift. From rest at 27 points nobody holds the tool for a second; how far does the tip
-- get? With friction, and, which only a simulation can do, without it.
--
--   --set seeds=N          devices, seeds 1 and on (3)
--   --set identified=FILE  what identify.lua wrote, on other devices; without it only as built

local compensation = require "compensation"
local difference = require "second_difference"
local print_table = require "print_table"
local rig = require "rig"
local statistics = require "statistics"

local seeds = trocar.args.seeds or 3
local rate, h = 4000, 16 -- [Hz], ticks

local built = rig.build {}
local to_and_fro = trocar.ShuttleMotion {
  name = "to_and_fro", begin = "3600 s", stroke = "30 mm", turning = "5 m/s^2",
}
local shake = trocar.ChirpMotion {
  name = "shake", begin = "3600 s", amplitude = "3 mm", from = "2 Hz", to = "8 Hz",
  duration = "4 s", taper = "0.5 s",
}
local offset = to_and_fro.offset + shake.offset
local velocity = to_and_fro.velocity + shake.velocity
local clamps = {}
for i, site in ipairs { "tip", "handle" } do
  clamps[i] = trocar.PoseSpring {
    name = site .. "_clamp", stiffness = { "0", "0", "0" }, damping = "30 N s/m",
    position = built.tool[site].position, velocity = built.tool[site].velocity,
    offset = offset, offset_velocity = velocity,
  }
  clamps[i].force:to(built.device[site .. "_load"])
end

local clamped = {
  ["device.handle_offset"] = "-100 mm", ["tool.handle_offset"] = "-100 mm",
  ["tip_clamp.stiffness"] = { "20 N/mm", "20 N/mm", "20 N/mm" },
  ["handle_clamp.stiffness"] = { "20 N/mm", "20 N/mm", "20 N/mm" },
}

local function with(...)
  local all = {}
  for _, set in ipairs { ... } do
    for name, value in pairs(set) do all[name] = value end
  end
  return all
end

-- Force on the tool and its acceleration along an axis while the carriage moves.
local function carry(axis, seed, seconds, set)
  local run = trocar.run { rate = "4 kHz", duration = seconds, seed = seed,
    set = with(clamped, set), keep = { clamps[1].force, clamps[2].force, built.tool.tip,
      to_and_fro.steady, velocity } }
  assert(#run.faults == 0, run.faults[1])
  local force = run:samples(clamps[1].force[axis])
  for k, more in ipairs(run:samples(clamps[2].force[axis])) do force[k] = force[k] + more end
  local moved = {
    force = force, position = run:samples(built.tool.tip.position[axis]),
    steady = run:samples(to_and_fro.steady), speed = run:samples(velocity[axis]),
  }
  run:discard()
  return moved
end

-- A start from which a motion of `way` along an axis stays around the middle of the workspace.
local function start(axis, way)
  local at = { x = "0 mm", y = "0 mm", z = "85 mm" }
  at[axis] = ("%.6g mm"):format((axis == "z" and 85 or 0) - way / 2)
  return { ["device.start_position"] = { at.x, at.y, at.z } }
end

-- [N] at a speed [m/s].
local function drag(axis, speed, seed, set)
  local way = 30 + 1000 * speed ^ 2 / 5
  local seconds = ("%.4g s"):format(4 * (0.03 / speed + 2 * speed / 5) + speed / 5)
  local moved = carry(axis, seed, seconds, with(set, start(axis, way), {
    ["to_and_fro.begin"] = "0 s", ["to_and_fro.axis"] = axis,
    ["to_and_fro.speed"] = ("%g m/s"):format(speed) }))
  local columns, target = { {}, {}, {} }, {}
  local first = math.floor(rate * (0.03 / speed + 3 * speed / 5)) -- after the first way
  for k = first, #moved.force - h do
    if moved.steady[k] == 1 then
      local n = #target + 1
      columns[1][n] = difference.of(moved.position, k, h, rate)
      columns[2][n] = moved.speed[k] > 0 and 1 or -1
      columns[3][n] = 1
      target[n] = difference.weighted(moved.force, k, h)
    end
  end
  return trocar.least_squares { columns = columns, target = target }.solution[2]
end

-- [kg]
local function mass(axis, seed, set)
  local moved = carry(axis, seed, "4 s", with(set, start(axis, 0), {
    ["shake.begin"] = "0 s", ["shake.axis"] = axis }))
  local columns, target = { {}, {}, {}, {} }, {}
  local speed, way = {}, {}
  for k = 2, #moved.force - 1 do
    speed[k] = 0.5 * rate * (moved.position[k + 1] - moved.position[k - 1])
    way[k] = speed[k] > 0 and 1 or speed[k] < 0 and -1 or 0
  end
  for k = rate // 2, #moved.force - rate // 2, 4 do
    local n = #target + 1
    columns[1][n] = difference.of(moved.position, k, h, rate)
    columns[2][n] = difference.weighted(speed, k, h)
    columns[3][n] = difference.weighted(way, k, h)
    columns[4][n] = 1
    target[n] = difference.weighted(moved.force, k, h)
  end
  return trocar.least_squares { columns = columns, target = target }.solution[1]
end

-- [m], at each of 27 points.
local function drift(seed, set)
  local far = {}
  for _, x in ipairs { -25, 0, 25 } do
    for _, y in ipairs { -25, 0, 25 } do
      for _, z in ipairs { 65, 85, 105 } do
        local run = trocar.run { rate = "1 kHz", duration = "1 s", seed = seed, keep = { built.tool.tip },
          set = with(set, {
          ["device.start_position"] = { x .. " mm", y .. " mm", z .. " mm" } }) }
        assert(#run.faults == 0, run.faults[1])
        far[#far + 1] = run:drift(built.tool.tip.position)
        run:discard()
      end
    end
  end
  return far
end

local function over_devices(measure)
  local values = {}
  for seed = 1, seeds do values[seed] = measure(seed) end
  return statistics.mean(values)
end

local function report(title, set, compensated)
  local lines = {}
  for i, axis in ipairs { "x", "y", "z" } do
    local drags = {}
    for s, speed in ipairs { 0.05, 0.2, 0.5 } do
      drags[s] = over_devices(function(seed) return drag(axis, speed, seed, set) end)
    end
    local kg = over_devices(function(seed) return mass(axis, seed, set) end)
    lines[i] = { axis, ("%.3f"):format(drags[1]), ("%.3f"):format(drags[2]), ("%.3f"):format(drags[3]),
      ("%.3f"):format(kg) }
    trocar.publish("transparency", { axis = axis, compensated = compensated, drag_005 = drags[1],
      drag_02 = drags[2], drag_05 = drags[3], mass = kg })
  end
  print_table(("Transparency, %s; mean of %d devices"):format(title, seeds),
    { "", "drag N at 0.05 m/s", "0.2 m/s", "0.5 m/s", "apparent mass kg" }, lines)

  lines = {}
  for i, friction in ipairs { true, false } do
    local far = drift(1, with(set, { ["device.friction"] = friction },
      friction and {} or { ["friction.share"] = 0 }))
    local worst = math.max(table.unpack(far))
    lines[i] = { friction and "with friction" or "without",
      ("%.4f"):format(1000 * statistics.mean(far)), ("%.4f"):format(1000 * worst) }
    trocar.publish("drift", { compensated = compensated, friction = friction,
      mean = statistics.mean(far), worst = worst })
  end
  print_table("Drift of the tip in 1 s on a grid of 27 points, " .. title,
    { "", "mean mm", "worst mm" }, lines)
end

local known = compensation.given()
report("as built", {}, false)
if known then
  report("compensated", compensation.settings(known), true)
else
  print "Compensation needs --set identified=FILE, which identify.lua writes.\n"
end
