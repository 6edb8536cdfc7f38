-- 04_two_rates.lua: breathing tissue at 100 Hz under a servo at 1 kHz.
--
-- Teaches: threads. What needs to be fast runs in one, what is slow or costly in another, and
-- a value that crosses says how: `latest` gives the newest one and calls it stale when it is
-- older than you allow. A wall renders at 1 kHz; the tissue behind it breathes and yields
-- slowly under the wall's load, 100 times a second.
-- The two threads are a loop: load goes to the tissue, the surface to the wall. `delay` says
-- where it is cut, and what is there at first.

local servo = trocar.thread { rate = "1 kHz", priority = 80 }
local scene = trocar.thread { rate = "100 Hz", priority = 40 }

local laparoscope = servo.Laparoscope { hand = "push" }
local wall = servo.Wall {
  at = laparoscope.tip,
  point = { 0, 0, "105 mm" },
  normal = { 0, 0, -1 },
  stiffness = "1 N/mm",
}
local breath = scene.Sine { amplitude = "3 mm", frequency = "0.25 Hz" }
local tissue = scene.Creep { load = wall.load:latest { stale = "5 ms" }, compliance = "0.1 mm/N" }

-- The normal points at the hand: a surface that breathes out moves along it, one that yields
-- moves against it.
local surface = (breath.value - tissue.depth:delay { initial = "0 mm" }):as "surface"
surface:latest { stale = "30 ms" }:to(wall.offset)

-- Try it:
--   trocar run scripts/tutorial/04_two_rates.lua --for 8s --clock simulated
-- The hand pushes with the same force; the surface goes out and in with the breath, and yields:
-->       2.05    0.88    0.04  112.42               -6.77
-->       4.10    0.99    0.04  113.98               -8.64
-->       8.00    0.37    0.04   87.18                0.00
-->   thread servo: 8000 ticks at 1000 Hz
-->   thread scene: 800 ticks at 100 Hz
-->   no faults
