-- Trajectory tracking: a chirp of 40 mm along the tool's axis, 0.1 to 1 Hz, tapered, nobody holding
-- the tool. An impedance controller pulls the tip along by a spring of 15 N/mm with 30 N s/m; what
-- the motion needs besides its weight is either the spring's business (open loop, as in the
-- paper) or fed forward: inertia, friction along the motion that is known, gains, weight.
--
-- The error is that of the encoders' tip against the reference, over the whole chirp.
--
--   --set seeds=N          devices, seeds 1 and on (5)
--   --set identified=FILE  what identify.lua wrote, on other devices; without it only open loop

local compensation = require "compensation"
local paper = require "paper"
local print_table = require "print_table"
local rig = require "rig"
local statistics = require "statistics"

local seeds = trocar.args.seeds or 5
local amplitude = paper.chirp.amplitude / 1000
local duration = "22 s"

local function chirp(name)
  return trocar.ChirpMotion {
    name = name, axis = "z", amplitude = "40 mm", from = "0.1 Hz", to = "1 Hz",
    begin = "0.5 s", duration = "20 s", taper = "2 s",
  }
end

local reference, ahead = chirp "reference_motion", chirp "ahead"
local built = rig.build { motion = ahead }
built.hold = rig.hold(built, { "10 N/mm", "10 N/mm", "15 N/mm" })
reference.offset:to(built.hold.offset)
reference.velocity:to(built.hold.offset_velocity)

local function track(seed, set)
  local all = { ["hold.damping"] = "30 N s/m" }
  for name, value in pairs(set) do all[name] = value end
  local run = trocar.run { rate = "4 kHz", duration = duration, seed = seed, set = all,
    keep = { built.hold.displacement, reference.offset, reference.velocity } }
  assert(#run.faults == 0, run.faults[1])
  local take = { from = "0.5 s", to = "20.5 s", every = 4 }
  local error = run:samples(built.hold.displacement.z, take)
  local goal, speed = run:samples(reference.offset.z, take), run:samples(reference.velocity.z, take)
  run:discard()
  local tip = {}
  for k, e in ipairs(error) do tip[k] = goal[k] + e end
  -- tip(t) = a goal(t - lag) = a goal - a lag speed
  local fit = trocar.least_squares { columns = { goal, speed }, target = tip }
  local worst = 0
  for _, e in ipairs(error) do worst = math.max(worst, math.abs(e)) end
  return { rms = statistics.rms(error), worst = worst, gain = fit.solution[1],
    lag = -fit.solution[2] / fit.solution[1] }
end

local function report(title, set, compensated)
  local rows = {}
  for seed = 1, seeds do
    local row = track(seed, set)
    rows[seed] = row
    trocar.publish("chirp", { seed = seed, compensated = compensated, rms = row.rms,
      of_amplitude = row.rms / amplitude, of_range = row.rms / (2 * amplitude), worst = row.worst,
      gain = row.gain, lag = row.lag })
  end
  local function mean(field) return statistics.mean(statistics.column(rows, field)) end
  local highest = math.max(table.unpack(statistics.column(rows, "rms")))
  return { title, ("%.4f"):format(1000 * mean "rms"), ("%.4f"):format(1000 * highest),
    ("%.3f"):format(100 * mean "rms" / amplitude), ("%.3f"):format(50 * mean "rms" / amplitude),
    ("%.3f"):format(1000 * mean "worst"), ("%.2f"):format(1000 * mean "lag"),
    ("%.2f"):format(-360 * paper.chirp.highest * mean "lag") }
end

local known = compensation.given()
local lines = { { "paper", "", "", paper.chirp.rms .. " of either", "", "", "", "" },
  report("open loop", {}, false) }
if known then
  lines[#lines + 1] = report("fed forward", compensation.settings(known, { inertia = true }), true)
end
print_table(("Chirp of 40 mm, 0.1 to 1 Hz, along the tool; %d devices"):format(seeds),
  { "", "RMS mm", "worst device", "% of 40 mm", "% of 80 mm", "peak mm", "lag ms", "phase at 1 Hz °" },
  lines)
if not known then print "Feed-forward needs --set identified=FILE, which identify.lua writes.\n" end
