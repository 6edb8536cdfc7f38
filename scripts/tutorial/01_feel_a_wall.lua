-- 01_feel_a_wall.lua: a hand pushes the tool into a soft wall.
--
-- Teaches: a device, a fixture, and that placing a fixture at a site wires it.
-- The wall is as stiff as an abdominal wall can be (2.2 N/mm). Its surface lies 105 mm
-- along the insertion axis; its normal points back at the hand. The simulated hand grips
-- the tool, pushes towards the wall, stays, and comes back.

local laparoscope = trocar.Laparoscope { hand = "push" }
trocar.Wall {
  at = laparoscope.tip,
  point = { 0, 0, "105 mm" },
  normal = { 0, 0, -1 },
  stiffness = "2.2 N/mm",
}
