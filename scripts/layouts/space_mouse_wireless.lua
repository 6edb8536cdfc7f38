-- space_mouse_wireless.lua: 3Dconnexion SpaceMouse Wireless by its cable. Full deflection is 1.
--
-- Axes as of space_navigator.lua, all six in report 1; buttons in report 3, when one changes. Source:
-- its report descriptor, as github.com/AndunHH/spacemouse shows it (SpaceMouseWireless.md). Not
-- tried on the device itself.

local function axis(byte)
  return { offset = 8 * byte }
end

return {
  vendor = "256f",
  product = "c62e",
  bytes = 13,
  fields = {
    translation = {
      report = 1, bits = 16, signed = true, scale = 1 / 350,
      x = axis(1), y = axis(3), z = axis(5),
      doc = "push on the cap, 1 at its end: right, towards the user, down",
    },
    rotation = {
      report = 1, bits = 16, signed = true, scale = 1 / 350,
      x = axis(7), y = axis(9), z = axis(11),
      doc = "twist of the cap about these axes, 1 at its end",
    },
    left = { report = 3, offset = 8, bits = 1, held = "attached", doc = "button" },
    right = { report = 3, offset = 9, bits = 1, held = "attached", doc = "button" },
  },
}
