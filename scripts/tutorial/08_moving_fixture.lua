-- 08_moving_fixture.lua: a fixture that moves, fixtures/moving_groove.lua.
--
-- Teaches: inputs of a law. The file declares `shift`, a length; in the script it is an input like
-- any other, so a source, another fixture or a value from a slower thread can move the groove.
-- Here it breathes: the groove of tutorial 05 goes 3 mm to both sides, every four seconds, and
-- takes the tool along.

local laparoscope = trocar.Laparoscope { hand = "relaxed" }
local breath = trocar.Sine { amplitude = "3 mm", frequency = "0.25 Hz" }
local groove = trocar.LuaFixture {
  file = "fixtures/moving_groove.lua", at = laparoscope.tip, shift = breath.value, stiffness = "1 N/mm",
}

local run = trocar.run { duration = "8 s" }
trocar.publish("moved", {
  tip_from = run:min(laparoscope.tip.position.x),
  tip_to = run:max(laparoscope.tip.position.x),
  distance = run:max(groove.distance),
})

-- Try it:
--   trocar run scripts/tutorial/08_moving_fixture.lua --clock simulated
-- The tip follows it to both sides; friction holds it back by less than half a millimetre:
--> moved
-->   distance     tip_from     tip_to
-->   0.000465893  -0.00257904  0.00263075
