-- space_navigator.lua: 3Dconnexion SpaceNavigator. Full deflection, 350 counts, is 1.
--
-- Axes as the device has them: x right, y towards the user, z down (by the signs that
-- github.com/JakubAndrysek/PySpaceMouse turns them with). Source: the device's report descriptor and
-- recorded reports, as github.com/AndunHH/spacemouse shows them (SpaceNavigator.md). Not tried on
-- the device itself.
--
-- Report 1 is the push, 2 the twist, both for as long as the cap is off its rest; 3 the buttons,
-- when one changes.

local function axis(byte)
  return { offset = 8 * byte }
end

return {
  vendor = "046d",
  product = "c626",
  bytes = 7,
  fields = {
    translation = {
      report = 1, bits = 16, signed = true, scale = 1 / 350,
      x = axis(1), y = axis(3), z = axis(5),
      doc = "push on the cap, 1 at its end: right, towards the user, down",
    },
    rotation = {
      report = 2, bits = 16, signed = true, scale = 1 / 350,
      x = axis(1), y = axis(3), z = axis(5),
      doc = "twist of the cap about these axes, 1 at its end",
    },
    left = { report = 3, offset = 8, bits = 1, held = "attached", doc = "button" },
    right = { report = 3, offset = 9, bits = 1, held = "attached", doc = "button" },
  },
}
