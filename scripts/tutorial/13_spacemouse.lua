-- 13_spacemouse.lua: the tool moves as a SpaceMouse says.
--
-- Teaches: trocar.GenericHid, an input device by a layout of its reports. Here the layout is a
-- shipped one, scripts/layouts/space_navigator.lua; one of your own is a file beside the script, or
-- a table. Its fields are outputs: `translation` is the push on the cap, `left` a button.
--
-- fixtures/steer.lua, in scripts, makes a velocity of the push, moves a goal with it, and pulls the
-- tool there. Its force is a load, as of a hand; the wall pushes back through the motors. Let go,
-- and the goal stays where it is.
--
-- Without a mouse `play` stands in for one: reports, as bytes, with their times. This one is pushed
-- to the right for half a second, and then down until the tool is in the wall. With yours:
--   trocar run scripts/tutorial/13_spacemouse.lua --set mouse=space_navigator

local function pushed(from, to, bytes)
  local reports = {}
  for ms = from, to, 10 do reports[#reports + 1] = { at = ms .. " ms", bytes = bytes } end
  return reports
end
local recorded = pushed(500, 990, "01 5e 01 00 00 00 00") -- x: 0x015e, 350 counts, full deflection
table.move(pushed(1500, 2990, "01 00 00 00 00 5e 01"), 1, 150, #recorded + 1, recorded) -- z

local mouse = trocar.GenericHid {
  name = "mouse",
  layout = trocar.args.mouse or "space_navigator",
  play = trocar.args.mouse and {} or recorded,
  needed = trocar.args.mouse ~= nil, -- else a run goes on without it, and says so in mouse.status
}
local laparoscope = trocar.Laparoscope { hand = "none" }
local steer = trocar.LuaFixture {
  file = "../fixtures/steer.lua", push = mouse.translation,
  position = laparoscope.tip.position, velocity = laparoscope.tip.velocity,
}
steer.force:to(laparoscope.tip.load)
trocar.Wall { at = laparoscope.tip, point = { 0, 0, "105 mm" }, normal = { 0, 0, -1 } }

-- Try it:
--   trocar run scripts/tutorial/13_spacemouse.lua --for 4s --clock simulated
-- First it goes to the right, then into the wall, which bears what the spring has left:
-->   time [s]                tip [mm]      force of steer [N]   force of wall [N]
-->       0.00    0.37    0.05   84.95    0.00    0.00    0.00                0.00
-->       1.02   29.20    0.05   82.04    0.62    0.00    1.26                0.00
-->       2.05   35.27    0.04  108.57    0.20    0.00    3.51               -1.78
-->       4.00   35.40    0.07  114.83    0.01    0.00    6.00               -4.92
-->   wall pushed hardest at 3.16 s, with 4.92 N; at the end with 4.92 N
-->   no faults
