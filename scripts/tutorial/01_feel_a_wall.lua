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

-- Try it:
--   trocar run scripts/tutorial/01_feel_a_wall.lua --for 5s --clock simulated
-- The tip goes 3.7 mm into the wall, which pushes back along z, against the hand:
-->   time [s]                tip [mm]   force of wall [N]
-->                  x       y       z                   z
-->       0.00    0.37    0.05   84.95                0.00
-->       1.28    0.54    0.07  105.14               -0.32
-->       5.00    0.83    0.06  108.71               -8.16
-->   wall pushed hardest at 1.93 s, with 8.16 N; at the end with 8.16 N
-->   no faults
