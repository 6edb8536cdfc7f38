-- Which imperfection of the device makes which part of Table I's error: each is switched off by
-- itself, on the same devices, and the figures move. "share" is the part of the mean error that
-- goes with it, "moves" by how much a single device's error changes, whichever way.
--
--   --set seeds=N       devices, seeds 1 and on (4)
--   --set readings=N    of the instruments in each dwell (1000: their noise is not the matter here)

local bench = require "incision_bench"
local paper = require "paper"
local print_table = require "print_table"
local statistics = require "statistics"

local seeds = trocar.args.seeds or 4
local readings = trocar.args.readings or 1000
local built = bench.build()

-- Name, and the settings that switch it off. A new imperfection of the plant goes here.
local imperfections = {
  { "none is off", {} },
  { "drive gain", { ["device.gain_error"] = false } },
  { "gain drift", { ["device.gain_drift"] = false } },
  { "friction", { ["device.friction"] = false } },
  { "Stribeck", { ["device.stribeck"] = false } },
  { "compliance", { ["device.compliance"] = false } },
  { "cogging", { ["device.cogging"] = false } },
  { "force ripple", { ["device.ripple"] = false } },
  { "quantisation", { ["device.quantisation"] = false } },
  { "homing error", { ["device.homing_error"] = false } },
  { "weight error", { ["device.weight_error"] = false } },
  { "all are off", { ["device.ideal"] = true } },
}

local measured = {}
for i, one in ipairs(imperfections) do
  measured[i] = bench.table1(built, 1, seeds, { set = one[2], readings = readings })
end

-- How much a device's error moves, whichever way.
local function moved(rows, base)
  local sum = 0
  for k, row in ipairs(rows) do sum = sum + math.abs(row.error - base[k].error) end
  return sum / #rows
end

local function mean(rows, field) return statistics.mean(statistics.column(rows, field)) end

for c, case in ipairs(paper.table1) do
  local lines, whole = {}, mean(measured[1][c], "error")
  for i, one in ipairs(imperfections) do
    local rows = measured[i][c]
    local error = mean(rows, "error")
    local share = (whole - error) / whole
    lines[i] = { one[1], ("%.2f ± %.2f"):format(100 * error,
      100 * statistics.spread(statistics.column(rows, "error"))),
      i == 1 and "" or ("%.0f"):format(100 * share),
      i == 1 and "" or ("%.2f"):format(100 * moved(rows, measured[1][c])), ("%.5f"):format(mean(rows, "r2")),
      ("%.3f"):format(1000 * mean(rows, "hysteresis")) }
    trocar.publish("ablation", { axis = case.axis, desired = 1000 * case.desired, without = one[1],
      error = error, spread = statistics.spread(statistics.column(rows, "error")),
      share = i == 1 and 0 or share, moved = moved(rows, measured[1][c]),
      r2 = mean(rows, "r2"), hysteresis = mean(rows, "hysteresis") })
  end
  print_table(("%s, %d N/mm (paper: %.1f %%, R² %.3f); %d devices"):format(case.axis, case.desired,
    case.error, case.r2, seeds), { "without", "error %", "share %", "moves %", "R²", "hyst mm" }, lines)
end
