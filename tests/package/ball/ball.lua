-- ball.lua: a hand pushes the tool into a ball, until it slips off beside.
-- What the ball answers 1.5 s from the beginning, and what k (r - |p - c|) is there.
local laparoscope = trocar.Laparoscope { hand = "push" }
local ball = trocar.Ball {
  at = laparoscope.tip,
  center = { "1 mm", 0, "115 mm" },
  radius = "20 mm",
  stiffness = "1 N/mm",
}

local run = trocar.run { duration = "3 s" }
local function at(signal) return run:at(signal, "1.5 s") end
local function norm(x, y, z) return math.sqrt(x ^ 2 + y ^ 2 + z ^ 2) end
local tip = laparoscope.tip.position
trocar.publish("ball", {
  force = norm(at(ball.force.x), at(ball.force.y), at(ball.force.z)),
  expected = 1000 * (0.020 - norm(at(tip.x) - 0.001, at(tip.y), at(tip.z) - 0.115)),
})
