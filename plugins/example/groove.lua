-- groove.lua: a hand pushes the tool along a groove beside its way.
-- How far the tip is from the line after 1.5 s, and that the groove answers with k times that.
local laparoscope = trocar.Laparoscope { hand = "push" }
local groove = trocar.Groove {
  at = laparoscope.tip,
  point = { "2 mm", 0, "110 mm" },
  stiffness = "0.5 N/mm",
}

local run = trocar.run { duration = "2 s" }
local function at(signal) return run:at(signal, "1.5 s") end
trocar.publish("groove", {
  force = at(groove.force.x),
  expected = 500 * (0.002 - at(laparoscope.tip.position.x)),
})
