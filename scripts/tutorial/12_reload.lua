-- 12_reload.lua: another law with the hand on the tool.
--
-- Teaches: a law can be exchanged while it runs. With --watch you save its file in your editor;
-- here the script says when, so that you can see it in virtual time. After one second the groove
-- of tutorial 05 becomes one whose middle is free (fixtures/groove_wide.lua); the force goes over
-- within 0.2 s. The version that comes at two seconds is refused, for it has other outputs, and
-- nobody feels it.
--
-- With a device, or the simulated one in real time, try this, and edit fixtures/groove.lua:
--   trocar run scripts/tutorial/05_first_fixture.lua --watch

local laparoscope = trocar.Laparoscope { hand = "push" }
local groove = trocar.LuaFixture { file = "fixtures/groove.lua", at = laparoscope.tip, stiffness = "2 N/mm" }

local run = trocar.run {
  duration = "3 s",
  reloads = {
    { at = "1 s", groove = "fixtures/groove_wide.lua" },
    { at = "2 s", groove = "fixtures/ratchet.lua" },
  },
}
trocar.publish("force", { former = run:at(groove.force.x, "0.9 s"), wide = run:at(groove.force.x, "1.9 s") })

-- Try it:
--   trocar run scripts/tutorial/12_reload.lua --clock simulated
-- Two verdicts, and the force in x before and after the first of them:
-->   no faults
-->   reload: fixtures/groove_wide.lua took over in groove at 1.000 s
-->   reload: fixtures/ratchet.lua did not take over in groove at 2.000 s:
-->     ratchet.lua: the output "distance" has gone or changed, but is wired: end the run, and begin anew
--> force
-->   former      wide
-->   -0.0914535  -0.370644
