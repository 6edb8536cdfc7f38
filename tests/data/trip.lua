-- SPDX-License-Identifier: Apache-2.0
-- A hand holds the handle; after 6 s a wall jumps into the tool, which trips.
local laparoscope = trocar.Laparoscope { hand = "firm" }
local jump = trocar.Step { to = "60 mm", at = "6 s" }
local wall = trocar.Wall {
  at = laparoscope.tip,
  point = { 0, 0, "115 mm" },
  normal = { 0, 0, -1 },
  stiffness = "2 N/mm",
  offset = jump.value,
}
trocar.Capture {
  name = "touch",
  file = "trip_touch.mcap",
  signal = wall.load,
  above = "2 N",
  before = "1 s",
  after = "0.5 s",
}
