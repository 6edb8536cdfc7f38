-- dualshock4.lua: Sony DualShock 4 by USB, both of its versions.
--
-- Sticks from -1 (left, up) to 0.992 (right, down) with 0 at rest, triggers from 0 to 1, hat 0
-- north and clockwise to 7, 8 at rest. Source: struct dualshock4_input_report_usb in Linux'
-- drivers/hid/hid-playstation.c. Not tried on the device itself. It sends all the time.

local function stick(byte, doc)
  return { report = 1, offset = 8 * byte, bits = 8, centre = 128, scale = 1 / 128, doc = doc }
end
local function trigger(byte, doc)
  return { report = 1, offset = 8 * byte, bits = 8, scale = 1 / 255, doc = doc }
end

local fields = {
  left_x = stick(1, "left stick, to the right"),
  left_y = stick(2, "left stick, down"),
  right_x = stick(3, "right stick, to the right"),
  right_y = stick(4, "right stick, down"),
  hat = { report = 1, offset = 40, bits = 4, rest = 8, doc = "0 north, clockwise to 7; 8 at rest" },
  l2_pull = trigger(8, "left trigger"),
  r2_pull = trigger(9, "right trigger"),
}
local buttons = {
  "square", "cross", "circle", "triangle", "l1", "r1", "l2", "r2", "share", "options", "l3", "r3", "ps", "touchpad",
}
for i, name in ipairs(buttons) do
  fields[name] = { report = 1, offset = 43 + i, bits = 1, doc = "button" }
end

return { vendor = "054c", product = { "05c4", "09cc" }, bytes = 64, fields = fields }
