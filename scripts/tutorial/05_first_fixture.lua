-- 05_first_fixture.lua: a fixture of your own in ten lines, fixtures/groove.lua.
--
-- Teaches: a force law in Lua that runs inside the loop. The file says which parameters the law
-- has, with units and ranges, which outputs, and what one step does; numbers in it are SI. The
-- groove pulls the tip to the insertion axis and leaves it free along the axis. Beside it
-- stands a wall, written in C++: in a script the two look alike.

local laparoscope = trocar.Laparoscope { hand = "push" }
trocar.LuaFixture { file = "fixtures/groove.lua", at = laparoscope.tip, stiffness = "0.4 N/mm" }
trocar.Wall { at = laparoscope.tip, point = { 0, 0, "105 mm" }, normal = { 0, 0, -1 }, stiffness = "2.2 N/mm" }

-- Try it, also with --set groove.stiffness="1 N/mm"; then break the law and see what you are told:
--   trocar run scripts/tutorial/05_first_fixture.lua --for 5s --clock simulated
-- The groove pulls towards the axis, the wall resists where the hand pushes into it:
-->   time [s]                tip [mm]   force of groove [N]   force of wall [N]
-->       0.00    0.37    0.05   84.95         -0.15   -0.02                0.00
-->       5.00    0.43    0.02  108.70         -0.17   -0.01               -8.15
-->   groove pushed hardest at 1.93 s, with 0.17 N; at the end with 0.17 N
-->   no faults
