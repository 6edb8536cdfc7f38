-- 02_incision.lua: springs at the incision, as in Table I of the device's paper.
--
-- Teaches: an experiment. The script runs its graph itself, several times with other
-- settings, fits a line to what it measured and publishes a row for each.
-- Known loads (a staircase of weights, up and down on both sides) pull at the incision, a
-- spring renders against them; the slope of load over displacement is the stiffness that
-- a person would feel. It differs from what was asked for: the simulated drives give
-- 96.5 % of what they are told, and friction holds against small changes.

local laparoscope = trocar.Laparoscope { hand = "none" }
local spring = trocar.Spring { at = laparoscope.incision, damping = "20 N s/m" }
local weights = trocar.Staircase { at = laparoscope.incision, peak = "18 N", levels = 9 }

for _, case in ipairs { { "x", "5 N/mm" }, { "x", "15 N/mm" }, { "y", "6 N/mm" }, { "y", "18 N/mm" } } do
  local axis, stiffness = table.unpack(case)
  local run = trocar.run {
    rate = "4 kHz",
    duration = "60 s",
    set = { ["spring.axis"] = axis, ["spring.stiffness"] = stiffness, ["staircase.axis"] = axis },
  }
  local line = run:fit { x = spring.stretch, y = weights.load }
  trocar.publish("table1", { axis = axis, desired = stiffness, slope = line.slope, r2 = line.r2 })
end

-- Try it (four minutes of virtual time take some seconds):
--   trocar run scripts/tutorial/02_incision.lua --clock simulated
-- Slopes are in N/m, as all numbers inside are SI:
--> run 1: 60.000 s at 4000 Hz, spring up to 18.74 N, staircase up to 18.00 N, no faults
--> table1
-->   axis  desired  r2        slope
-->   x     5 N/mm   0.999783  4821.24
-->   x     15 N/mm  0.999882  14412.9
-->   y     6 N/mm   0.999807  5802.68
-->   y     18 N/mm  0.999933  17386.6
