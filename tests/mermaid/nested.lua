-- Groups in groups, two devices, and names that are Mermaid's keywords.
local Rig = trocar.group {
  name = "Rig",
  build = function()
    local style = trocar.Laparoscope { name = "style" }
    trocar.Wall { name = "graph", at = style.tip, offset = "3 mm" }
    return { pose = style.pose }
  end,
}
local left = Rig { name = "subgraph" }
local click = trocar.Laparoscope { name = "click" }
trocar.Sum { name = "default", terms = { left.pose.position, click.pose.position } }
