-- 07_state.lua: a law that remembers, fixtures/ratchet.lua.
--
-- Teaches: `state` is a table of numbers, true and false that the law keeps from tick to tick.
-- It begins as it is declared in each run. Locals outside of `step` would do as well, but what is
-- in `state` also survives when the law is replaced while it runs.
-- The ratchet lets the tool go in, tooth by tooth, and holds it at the farthest one when the hand
-- pulls: the force points into the body then.

local laparoscope = trocar.Laparoscope { hand = "push" }
local ratchet = trocar.LuaFixture { file = "fixtures/ratchet.lua", at = laparoscope.tip }

local run = trocar.run { duration = "8 s" }
trocar.publish("ratchet", {
  first_tooth = run:first(ratchet.teeth),
  last_tooth = run:last(ratchet.teeth),
  held_back = run:max(ratchet.behind),
  force = run:max(ratchet.force.z),
})

-- Try it:
--   trocar run scripts/tutorial/07_state.lua --clock simulated
-- The hand goes in to the 27th tooth, at 135 mm, and does not get out again:
-->       5.12    1.52    0.05  138.92                   0.00
-->       8.00    0.60    0.08  125.34                   9.66
--> ratchet
-->   first_tooth  force    held_back   last_tooth
-->   16           9.66146  0.00966146  27
