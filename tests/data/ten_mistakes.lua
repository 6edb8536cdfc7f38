-- Ten different mistakes, each found in one go: trocar check tests/data/ten_mistakes.lua

local laparoscope = trocar.Laparoscope { hand = "push" }
local breath = trocar.Sine { amplitude = "3 mm", frequency = "0.25 Hz" }
local wall = trocar.Wall { at = laparoscope.tip, offset = breath.value, stifness = "2.2 N/mm" }
trocar.Wall { name = "soft", at = laparoscope.tip, stiffness = "2.2 N" }
trocar.Wall { name = "hard", at = laparoscope.tip, stiffness = "900 N/mm" }
trocar.Wall { at = laparoscope.tip }
trocar.Spring { at = laparoscop.incision }
trocar.Srping { at = laparoscope.tip }
trocar.Spring { name = "second_spring", at = laparoscope.tipp }
local surface = wall.force + wall.depth
breath.value:to(wall.offset)
trocar.Laparoscope { name = "second", hand = "pull" }
