-- 10_group.lua: a constructor of your own.
--
-- Teaches: trocar.group. Parts that belong together become one thing with parameters, inputs and
-- outputs, which is made as often as you like and named like a component. What is inside can be
-- seen: layers.skin.force is a signal, and --set layers.skin.stiffness="1 N/mm" reaches it.
-- Here two walls behind each other are tissue: soft skin, and 5 mm deeper something harder.

local Layers = trocar.group {
  name = "Layers",
  parameters = {
    soft = { "0.5 N/mm", range = { "0 N/mm", "5 N/mm" }, doc = "stiffness of the skin" },
    hard = { "2 N/mm", range = { "0 N/mm", "5 N/mm" }, doc = "stiffness of what is below" },
  },
  inputs = { "site" },
  build = function(parameters, inputs)
    local function layer(name, depth, stiffness)
      return trocar.Wall {
        name = name, at = inputs.site, point = { 0, 0, depth }, normal = { 0, 0, -1 }, stiffness = stiffness,
      }
    end
    local skin = layer("skin", "105 mm", parameters.soft)
    local bone = layer("bone", "110 mm", parameters.hard)
    return { load = skin.load + bone.load }
  end,
}

local laparoscope = trocar.Laparoscope { hand = "push" }
local layers = Layers { site = laparoscope.tip, soft = "0.4 N/mm" }

local run = trocar.run { duration = "3 s" }
trocar.publish("layers", {
  load = run:max(layers.load),
  skin = run:max(layers.skin.depth),
  bone = run:max(layers.bone.depth),
})

-- Try it:
--   trocar run scripts/tutorial/10_group.lua --clock simulated
-- The skin yields 7 mm, what is below it 2 mm:
-->   layers.skin pushed hardest at 1.95 s, with 2.85 N; at the end with 2.85 N
-->   layers.bone pushed hardest at 1.95 s, with 4.25 N; at the end with 4.25 N
--> layers
-->   bone       load     skin
-->   0.0021228  7.09471  0.0071228
