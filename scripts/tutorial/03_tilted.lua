-- 03_tilted.lua: a tilted device held against gravity.
--
-- Teaches: what the group Laparoscope is made of, by wiring its parts by hand. Gravity is
-- held even when nothing is rendered: `hold` is an input of its own, which stays when a
-- fault ends the rendering. `mount` is a parameter that one component takes from another.

local device = trocar.SimulatedLaparoscope { mount = { pitch = "20 deg" }, hand = "none" }
local foaw = trocar.Foaw { position = device.position }
local tool = trocar.LaparoscopeKinematics { position = device.position, velocity = foaw.velocity }
local weight = trocar.GravityCompensation { position = device.position, mount = device.mount }
weight.effort:to(device.hold)

local run = trocar.run { duration = "10 s" }
trocar.publish("drift", { tip = run:drift(tool.tip.position) })

-- Try it:
--   trocar run scripts/tutorial/03_tilted.lua --clock simulated
-- Friction holds what little of the weight is not compensated, so the tip does not move:
-->   no faults
--> drift
-->   tip
-->   0
