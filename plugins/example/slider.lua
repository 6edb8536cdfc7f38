-- slider.lua: a device is asked for 12 N. Its handle bears 8 N, so the gate lets two thirds pass.
local slider = trocar.Slider { effort = "12 N" }

local run = trocar.run { duration = "20 ms" }
trocar.publish("slider", {
  sent = run:max(slider.effort_sent.axis1),
  scale = run:at(slider.scale, "19 ms"),
})
