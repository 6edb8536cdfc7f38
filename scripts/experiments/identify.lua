-- Identifies the device: gravity, friction, gains of the drives, delay. identification.lua says
-- how. Writes the mean of some devices to a Lua file that the other experiments take by
-- --set identified=FILE, and shows on devices that were not identified what it is worth: how much
-- of the balance of each axis is left unexplained, before and after.
--
--   --set file=FILE      what is written (identified.lua)
--   --set training=N     devices that are identified, seeds 101 and on (5)
--   --set seeds=N        devices that it is tried on, seeds 1 and on (5)

local identification = require "identification"
local print_table = require "print_table"
local rig = require "rig"
local statistics = require "statistics"

local path = trocar.args.file or "identified.lua"
local training = trocar.args.training or 5
local held_out = trocar.args.seeds or 5

local built = rig.build {}
built.hold = rig.hold(built, { "10 N/mm", "10 N/mm", "10 N/mm" })
identification.attach(built)
local found = identification.mean(built, training)

-- A table as Lua writes it, its keys in order.
local function text(value, indent)
  if type(value) ~= "table" then return ("%.9g"):format(value) end
  local parts = {}
  for key, part in pairs(value) do
    local name = type(key) == "number" and "" or key .. " = "
    parts[#parts + 1] = indent .. "  " .. name .. text(part, indent .. "  ") .. ",\n"
  end
  return "{\n" .. table.concat(parts) .. indent .. "}"
end

local file = assert(io.open(path, "w"))
file:write("-- Mean of ", training, " devices, by scripts/experiments/identify.lua; SI units.\nreturn ",
  text({ seeds = found.seeds, gain = found.gain, dry = found.dry, viscous = found.viscous,
    masses = found.masses, delay = found.delay }, ""), "\n")
file:close()

local lines = {}
for i = 1, 6 do
  local unit = i <= 3 and "N" or "N m"
  lines[i] = { i <= 3 and "slider " .. i or "ring " .. i - 3,
    ("%.4f ± %.4f"):format(found.gain[i], found.gain_spread[i]),
    ("%.4f ± %.4f %s"):format(found.dry[i], found.dry_spread[i], unit),
    ("%.4f ± %.4f"):format(found.viscous[i], found.viscous_spread[i]) }
end
print_table(("Identified on %d devices, mean ± standard deviation"):format(training),
  { "", "gain", "dry friction", "viscous, N s/m or N m s/rad" }, lines)

lines = {}
for name, value in pairs(found.masses) do
  lines[#lines + 1] = { name, ("%.4f ± %.4f"):format(value, found.masses_spread[name]) }
end
lines[#lines + 1] = { "delay", ("%.3f ms"):format(1000 * found.delay) }
print_table("Weight by the balance, SI", { "", "" }, lines)

local before, after = {}, {}
for seed = 1, held_out do
  before[seed], after[seed] = identification.residual(built, seed, found)
end
local rows = { before = statistics.mean(before), after = statistics.mean(after) }
print_table(("Left of the axes' balance on %d devices that were not identified, root mean square, N"):format(held_out),
  { "by the drawing", "as identified" },
  { { ("%.3f"):format(rows.before), ("%.3f"):format(rows.after) } })
trocar.publish("identify", { file = path, gain = found.gain, dry = found.dry, viscous = found.viscous,
  masses = found.masses, delay = found.delay, residual_before = rows.before, residual_after = rows.after })
