-- 06_parameters.lua: parameters and units of a law, fixtures/fluid.lua.
--
-- Teaches: a parameter is declared with a default, which gives its unit, and a range. Scripts,
-- --set and edits while it runs write quantities with any unit that fits; inside the law the
-- number is SI. What does not fit is refused before anything moves, with the range:
--
--   fluid.damping = "90 N s/m": must be within 0–40 N s/m
--   fluid.damping = "10 N/m": needs N s/m, e.g. "10 N s/m" (0–40 N s/m)
--
-- A hand pushes the tool through a thick fluid. Halfway the fluid becomes thicker: the change is
-- ramped, so that the hand feels no step.

local laparoscope = trocar.Laparoscope { hand = "push" }
local fluid = trocar.LuaFixture { file = "fixtures/fluid.lua", at = laparoscope.tip, limit = "6 N" }

local thin = trocar.run { duration = "3 s", set = { ["fluid.damping"] = "5 N s/m" } }
local thick = trocar.run {
  duration = "3 s",
  set = { ["fluid.damping"] = "5 N s/m" },
  edits = { { at = "1 s", ["fluid.damping"] = "0.03 N s/mm" } },
}
for _, run in ipairs { thin, thick } do
  trocar.publish("fluid", { speed = run:max(fluid.speed), force = run:min(fluid.force.z) })
end

-- Try it:
--   trocar run scripts/tutorial/06_parameters.lua --clock simulated
-- In the thicker fluid the hand is slower, and the force is larger:
--> fluid
-->   force      speed
-->   -0.320968  0.0642069
-->   -1.68632   0.0562153
