-- The device of all experiments: mounted at 20°, with everything that may compensate it.
--
--   statics ──┐
--   friction ─┼─ sum ─ drives (gain) ── effort ┐
--   inertia ──┘                                ├ device
--   weight ──────────── holding (gain) ── hold ┘
--
-- As built nothing is compensated but the nominal weight: open loop, as in the paper. What
-- `rig.compensation` returns, given to trocar.run as `set`, switches the rest on.
-- Signals that only a simulation knows are read in instrument.lua, and nowhere else.

local rig = {}

local function constructor(kind)
  if kind == "simulated" then return trocar.SimulatedLaparoscope end
  error(("device=%s: this build drives \"simulated\" only"):format(kind))
end

-- @param options.force_cap of what is rendered at the handle, "45 N" say
-- @param options.motion a ToolMotion that the tip is to follow: friction and inertia are then
--   compensated along the motion that is known, else along the measured one
function rig.build(options)
  local device = constructor(trocar.args.device or "simulated") {
    name = "device", mount = { pitch = "20 deg" }, hand = "none",
    handle_force_cap = options.force_cap or "20 N",
  }
  local speed = trocar.Foaw { name = "speed", position = device.position }
  local tool = trocar.LaparoscopeKinematics {
    name = "tool", position = device.position, velocity = speed.velocity,
  }
  local weight = trocar.GravityCompensation {
    name = "weight", position = device.position, mount = device.mount,
  }
  local statics = trocar.LaparoscopeStatics {
    name = "statics", jacobian = tool.jacobian, origin = tool.pose.position,
    tip_at = tool.tip.position, incision_at = tool.incision.position,
    handle_at = tool.handle.position,
  }
  local built = {
    device = device, speed = speed, tool = tool, weight = weight, statics = statics,
  }
  local position, velocity = device.position, speed.velocity
  local wanted = statics.effort
  if options.motion then
    local reference = trocar.ToolReference {
      name = "reference", position = device.position, offset = options.motion.offset,
      tip_velocity = options.motion.velocity, tip_acceleration = options.motion.acceleration,
    }
    position, velocity = reference.axes, reference.axes_velocity
    built.inertia = trocar.InertiaFeedForward {
      name = "inertia", share = 0, position = position, velocity = velocity,
      acceleration = reference.axes_acceleration,
    }
    wanted = wanted + built.inertia.effort
  end
  built.friction = trocar.FrictionCompensation {
    name = "friction", share = 0, position = position, velocity = velocity,
  }
  local drives = trocar.GainCalibration { name = "drives", wanted = wanted + built.friction.effort }
  local holding = trocar.GainCalibration { name = "holding", wanted = weight.effort }
  drives.effort:to(device.effort)
  holding.effort:to(device.hold)
  return built
end

-- Holds the tool by rendered springs: what an experiment does not test.
-- @param stiffness of x, y, z, "0" where the tool is to be free
function rig.hold(built, stiffness)
  local hold = trocar.PoseSpring {
    name = "hold", position = built.tool.tip.position, velocity = built.tool.tip.velocity,
    rotation = built.tool.pose.rotation, angular = built.tool.twist.angular,
    stiffness = stiffness, damping = "20 N s/m",
    rotational_stiffness = "60 N m/rad", rotational_damping = "0.3 N m s/rad",
  }
  hold.force:to(built.statics.tip_force)
  hold.moment:to(built.statics.tip_moment)
  return hold
end

return rig
