-- 11_sweep.lua: the same experiment on many devices.
--
-- Teaches: a sweep. A seed is a device: its drives, friction and encoders differ as those of
-- real ones do. The script runs each, keeps only the signals that it needs, fits, and publishes
-- a row for each and one for all. Rows are printed, and written by --json and --record.

local laparoscope = trocar.Laparoscope { hand = "none" }
local spring = trocar.Spring { at = laparoscope.incision, axis = "x", stiffness = "5 N/mm", damping = "20 N s/m" }
local weights = trocar.Staircase { at = laparoscope.incision, axis = "x", peak = "18 N", levels = 5 }

local slopes = {}
for seed = 1, 5 do
  local run = trocar.run { rate = "2 kHz", duration = "24 s", seed = seed, keep = { spring.stretch, weights.load } }
  local line = run:fit { x = spring.stretch, y = weights.load }
  run:discard()
  slopes[seed] = line.slope
  trocar.publish("device", { seed = seed, slope = line.slope, r2 = line.r2 })
end

local mean, squares = 0, 0
for _, slope in ipairs(slopes) do mean = mean + slope / #slopes end
for _, slope in ipairs(slopes) do squares = squares + (slope - mean) ^ 2 / (#slopes - 1) end
trocar.publish("all", { devices = #slopes, mean = mean, spread = math.sqrt(squares) })

-- Try it:
--   trocar run scripts/tutorial/11_sweep.lua --clock simulated
-- Slopes are in N/m; 5 N/mm were asked for:
--> device
-->   r2        seed  slope
-->   0.999647  1     4813.85
-->   0.999834  2     4863.93
-->   0.999718  3     4897.26
-->   0.999718  4     4895.81
-->   0.999719  5     4811.19
--> all
-->   devices  mean     spread
-->   5        4856.41  42.2309
