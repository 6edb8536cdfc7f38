-- Table I: springs at the incision, rendered by an open-loop impedance controller, and again by
-- one that knows the device.
--
-- Each row is measured on 20 simulated devices (seeds 1 to 20) which differ in gains, ripple and
-- homing. The compensation is that of the mean of five others (seeds 101 to 105): nothing of the
-- devices in the table was identified. incision_bench.lua says how it is measured.
--
--   --set seeds=N        devices in the table (20)
--   --set readings=N     of the instruments in each dwell, of which the mean is taken (10)
--   --set identified=FILE  what identify.lua wrote; else this script identifies, on --set training=N
--   --set plant=perfect  the device is its model: only the instruments' noise is left

local bench = require "incision_bench"
local compensation = require "compensation"
local identification = require "identification"
local paper = require "paper"
local print_table = require "print_table"
local statistics = require "statistics"

local seeds = trocar.args.seeds or 20
local readings = trocar.args.readings or 10
local perfect = trocar.args.plant == "perfect"

local known = compensation.given()
local training = trocar.args.training or 5
local built = bench.build()
if not (known or perfect) then
  identification.attach(built)
  known = identification.mean(built, training)
end

local function publish(rows, compensated)
  for _, case in ipairs(rows) do
    for _, row in ipairs(case) do
      trocar.publish("table1", { axis = row.axis, desired = row.desired, slope = row.slope,
        error = row.error, r2 = row.r2, seed = row.seed, compensated = compensated,
        slope_of_x_on_f = row.inverse, hysteresis = row.hysteresis, x = row.x, force = row.force })
    end
  end
end

local function report(title, rows)
  local lines = {}
  for i, case in ipairs(paper.table1) do
    local function mean(field) return statistics.mean(statistics.column(rows[i], field)) end
    local function spread(field) return statistics.spread(statistics.column(rows[i], field)) end
    lines[i] = {
      case.axis, case.desired, case.slope, case.error, case.r2,
      ("%.2f"):format(mean "slope" / 1000), ("%.2f"):format(mean "inverse" / 1000),
      ("%.2f ± %.2f"):format(100 * mean "error", 100 * spread "error"),
      ("%.5f ± %.5f"):format(mean "r2", spread "r2"), ("%.5f"):format(mean "bound"),
      ("%.3f"):format(1000 * mean "hysteresis"), ("%.2f"):format(1000 * mean "deflection"),
    }
  end
  print_table(("Table I, %s; %d devices, mean ± standard deviation"):format(title, seeds),
    { "", "K", "paper", "err %", "R²", "F on x", "x on F", "error %", "R²", "bound", "hyst mm", "up to mm" },
    lines)
end

local open = bench.table1(built, 1, seeds,
  { readings = readings, set = { ["device.ideal"] = perfect } })
publish(open, false)
report(perfect and "a perfect plant" or "open loop", open)
if not perfect then
  -- Viscous friction stays: nothing moves while it is read, and it helps to come to rest.
  local rows = bench.table1(built, 1, seeds,
    { readings = readings, set = compensation.settings(known, { viscous = false }) })
  publish(rows, true)
  report("identified on others and compensated", rows)
end
