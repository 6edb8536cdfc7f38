-- The workspace at the paper's sizes: a tool of 150 mm, 60 mm of travel for the rings' centre, a
-- stroke of 120 mm, 480° of roll. The paper gives no number for its Figure 4, so the volume is a
-- property of the geometry that docs/mathematics.md chooses, not a check of the paper.
--
--   --set tips=N   tried under each of 16 random shifts, a power of 2 (8192)

local paper = require "paper"
local print_table = require "print_table"

local size = paper.workspace
local workspace = trocar.LaparoscopeWorkspace {
  tips = trocar.args.tips or 8192,
  tool_length = size.tool .. " mm", centre_travel = size.radius .. " mm",
  slider_lowest = "-310 mm", slider_highest = (size.stroke - 310) .. " mm",
  ring_travel = size.roll / 2 .. " deg",
}

local function last(run, ...)
  local values = {}
  for i, output in ipairs { ... } do values[i] = run:last(output) end
  return table.unpack(values)
end

local began = os.clock()
local whole = trocar.run { duration = "1 ms" }
local took = os.clock() - began
local volume, error = last(whole, workspace.volume, workspace.standard_error)
local yaw, pitch, roll = last(whole, workspace.yaw, workspace.pitch, workspace.roll)
print_table("Workspace", { "", "here", "paper" }, {
  { "volume of the tip, cm³", ("%.0f ± %.0f (%.2f %%)"):format(1e6 * volume, 1e6 * error,
    100 * error / volume), "not given" },
  { "x, mm", ("%.1f to %.1f"):format(1000 * whole:last(workspace.lowest.x),
    1000 * whole:last(workspace.highest.x)), "not given" },
  { "y, mm", ("%.1f to %.1f"):format(1000 * whole:last(workspace.lowest.y),
    1000 * whole:last(workspace.highest.y)), "not given" },
  { "z, mm", ("%.1f to %.1f"):format(1000 * whole:last(workspace.lowest.z),
    1000 * whole:last(workspace.highest.z)), "not given" },
  { "yaw, pitch, °", ("±%.1f, ±%.1f"):format(math.deg(yaw), math.deg(pitch)), "not given" },
  { "roll on the axis, °", ("%.0f"):format(2 * math.deg(roll)), size.roll },
  { "processor time, s", ("%.1f"):format(took), "" },
})
trocar.publish("workspace", { volume = volume, standard_error = error, yaw = yaw, pitch = pitch,
  roll = 2 * roll, seconds = took })

local lines = {}
for i, translation in ipairs { 0, 20, 40, 50, 59.9 } do
  local run = trocar.run { duration = "1 ms", set = { ["laparoscope_workspace.tips"] = 256,
    ["laparoscope_workspace.poses"] = 256,
    ["laparoscope_workspace.translation"] = translation .. " mm" } }
  local insertion, turn = last(run, workspace.insertion, workspace.roll)
  lines[i] = { translation, ("%.1f"):format(1000 * insertion), ("±%.0f"):format(math.deg(turn)) }
  trocar.publish("translation", { translation = translation / 1000, insertion = insertion, roll = turn })
end
print_table("Upright tool, whatever the direction of the translation",
  { "translation mm", "insertion mm", "roll °" }, lines)

lines = {}
for i, depth in ipairs { 85, 110, 130 } do
  local run = trocar.run { duration = "1 ms", set = { ["laparoscope_workspace.tips"] = 256,
    ["laparoscope_workspace.poses"] = 256, ["laparoscope_workspace.depth"] = depth .. " mm" } }
  local tilt = run:last(workspace.tilt)
  lines[i] = { depth, ("%.1f"):format(math.deg(tilt)) }
  trocar.publish("depth", { depth = depth / 1000, tilt = tilt })
end
print_table("Tilt that is reached in every direction", { "depth mm", "tilt °" }, lines)
