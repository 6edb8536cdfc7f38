-- Identifies a device from what its own encoders and amplifiers tell, and from known weights that
-- are hung on it. Everything here is what a real device has; what only a simulation knows is in
-- instrument.lua, which this file must not use.
--
-- Gravity, friction and gains. A servo carries the tool to and fro along x, y and z, slowly and
-- then faster, while weights pull at the incision up and down. Where nothing accelerates, each
-- axis i balances
--
--   (J^T F_weights)_i = sum_p theta_p W_pi(q) + F_c,i sgn(v_i) + b_i v_i - g_i u_i
--
-- which is linear in all that is sought: the base masses theta (by gravity models with one unit
-- mass each), dry and viscous friction, and the gains g_i of the drives. The weights are known,
-- so the gains are absolute. Both directions of every motion are in it, or friction and gravity
-- would be one. The masses also have the drawing's values to within 20 %, as rows of their own.
--
-- Delay. A servo shakes the tool along z. The effort that was sent n ticks before explains the
-- acceleration of the sliders best for one n: the delay.

local difference = require "second_difference"
local statistics = require "statistics"

local identification = {}

local axes = { "axis1", "axis2", "axis3", "axis4", "axis5", "axis6" }
local window = 25 -- rows of which the mean is taken: 50 ms
local pin = 0.090 -- radius of the rings' pins [m]: ring rows count as forces there
local nominal = { slider = 0.320, link = 0.024, platform = 0.060, tool = 0.120, centre = 0.105,
  gimbal = 0.110, pin = 0.015 } -- [kg, m], by the drawing

-- The model's weight for one mass of 1 kg.
local function unit_weight(built, name, masses)
  local settings = {
    name = name, rate = "100 Hz", position = built.device.position, mount = built.device.mount,
    slider_mass = 0, link_mass = 0, platform_mass = 0, tool_mass = 0, tool_centre = 0,
    gimbal_mass = 0, pin_mass = 0,
  }
  for key, value in pairs(masses) do settings[key] = value end
  return trocar.GravityCompensation(settings)
end

-- Adds to a held rig what the identification needs: motions of its servo, weights and unit
-- masses. All of it rests until a run of the identification wakes it.
function identification.attach(built)
  local never = "3600 s"
  local motions = {}
  for i, axis in ipairs { "x", "y", "z" } do
    motions[i] = trocar.ShuttleMotion {
      name = "along_" .. axis, axis = axis, begin = never, stroke = "30 mm", turning = "0.2 m/s^2",
    }
  end
  local shake = trocar.ChirpMotion {
    name = "shake", axis = "z", begin = never, amplitude = "0.6 mm", from = "8 Hz", to = "25 Hz",
    duration = "8 s", taper = "0.5 s",
  }
  local offset = motions[1].offset + motions[2].offset + motions[3].offset + shake.offset
  local velocity = motions[1].velocity + motions[2].velocity + motions[3].velocity + shake.velocity
  offset:to(built.hold.offset)
  velocity:to(built.hold.offset_velocity)

  local pull = trocar.LaparoscopeStatics {
    name = "pull", rate = "500 Hz", jacobian = built.tool.jacobian,
    origin = built.tool.pose.position, tip_at = built.tool.tip.position,
    incision_at = built.tool.incision.position, handle_at = built.tool.handle.position,
  }
  for axis, seconds in pairs { x = "7 s", y = "9 s", z = "11 s" } do
    local weights = trocar.Staircase {
      name = "weights_" .. axis, axis = axis, peak = "0 N", levels = 5, duration = seconds,
    }
    weights.force:to(built.device.incision_load, pull.incision_force)
  end
  built.motions, built.shake, built.pull = motions, shake, pull
  built.units = {
    unit_weight(built, "unit_platform", { tool_mass = "1 kg" }),
    unit_weight(built, "unit_centre", { tool_mass = "1 kg", tool_centre = "1 m" }),
    unit_weight(built, "unit_gimbal", { gimbal_mass = "1 kg" }),
    unit_weight(built, "unit_slider", { slider_mass = "1 kg" }),
    unit_weight(built, "unit_pin", { pin_mass = "1 kg" }),
  }
end

-- [kg, kg m, kg, kg, kg]: what the unit weights are multiplied by, and how well the drawing knows it.
local drawn = {
  nominal.platform + 1.5 * nominal.link + nominal.tool, nominal.tool * nominal.centre,
  nominal.gimbal, nominal.slider + 0.5 * nominal.link, nominal.pin,
}

local servo = { ["hold.stiffness"] = { "8 N/mm", "8 N/mm", "8 N/mm" } }

local function settings(more)
  for name, value in pairs(servo) do more[name] = value end
  return more
end

local function sweeping(speeds)
  local set = settings { ["device.start_position"] = { "-20 mm", "-20 mm", "70 mm" } }
  for i, axis in ipairs { "x", "y", "z" } do
    set["along_" .. axis .. ".begin"] = "0 s"
    set["along_" .. axis .. ".speed"] = speeds[i]
    set["weights_" .. axis .. ".peak"] = "12 N"
  end
  return set
end

-- The rows of one sweep, one list for each axis.
local function sweep(built, seed, speeds)
  local run = trocar.run { rate = "2 kHz", duration = "12 s", seed = seed,
    set = sweeping(speeds), keep = { built.speed.velocity, built.device.effort_applied,
      built.pull.effort, "along_x.steady", "along_y.steady", "along_z.steady", "unit_platform.effort",
      "unit_centre.effort", "unit_gimbal.effort", "unit_slider.effort", "unit_pin.effort" } }
  assert(#run.faults == 0, run.faults[1])
  local take = { from = "0.3 s", every = 4 }
  local steady = {}
  for _, motion in ipairs(built.motions) do
    for i, yes in ipairs(run:samples(motion.steady, take)) do
      steady[i] = (steady[i] or 0) + yes
    end
  end
  local rows = {}
  for i, axis in ipairs(axes) do
    local row = { velocity = run:samples(built.speed.velocity[axis], take),
      effort = run:samples(built.device.effort_applied[axis], take),
      pull = run:samples(built.pull.effort[axis], take), units = {}, steady = steady }
    for p, unit in ipairs(built.units) do row.units[p] = run:samples(unit.effort[axis], take) end
    for k = 1, #row.effort do row.units[2][k] = row.units[2][k] - row.units[1][k] end
    rows[i] = row
  end
  run:discard()
  return rows
end

-- Adds the rows of an axis: means over windows in which it moves steadily one way, so that what
-- rings after a turn cancels.
local function append(columns, target, axis, rows)
  local scale = axis <= 3 and 1 or 1 / pin
  local slowest = axis <= 3 and 1e-3 or 0.01 -- [m/s, rad/s]: its direction is certain
  local masses, own = #drawn, #drawn + 3 * (axis - 1)
  for first = 1, #rows.velocity - window + 1, window do
    local last, way = first + window - 1, rows.velocity[first] > 0 and 1 or -1
    local good = true
    for k = first, last do
      good = good and rows.steady[k] == 3 and way * rows.velocity[k] > slowest
    end
    if good then
      local n = #target + 1
      for _, column in ipairs(columns) do column[n] = 0 end
      local function mean(values) return scale * statistics.mean(values, first, last) end
      for p = 1, masses do columns[p][n] = mean(rows.units[p]) end
      columns[own + 1][n] = -mean(rows.effort)
      columns[own + 2][n] = scale * way
      columns[own + 3][n] = mean(rows.velocity)
      target[n] = mean(rows.pull)
    end
  end
end

-- What the drawing says of the masses, as rows whose error is that of the others [N].
local function append_drawing(columns, target, error)
  for p, mass in ipairs(drawn) do
    local n = #target + 1
    for c, column in ipairs(columns) do column[n] = c == p and error / (0.2 * mass) or 0 end
    target[n] = error / 0.2
  end
end

-- The equations of one device: a column for each unknown, and the target.
local function equations(built, seed)
  local columns, target = {}, {}
  for c = 1, #drawn + 18 do columns[c] = {} end
  for _, speeds in ipairs { { "10 mm/s", "13 mm/s", "16 mm/s" }, { "40 mm/s", "32 mm/s", "45 mm/s" } } do
    for axis, rows in ipairs(sweep(built, seed, speeds)) do append(columns, target, axis, rows) end
  end
  return columns, target
end

local function statics_of(built, seed)
  local columns, target = equations(built, seed)
  append_drawing(columns, target, 0.1)
  return trocar.least_squares { columns = columns, target = target }
end

-- [s] from the gate to the tool.
local function delay_of(built, seed)
  local rate, h, longest = 4000, 16, 12
  local run = trocar.run {
    rate = "4 kHz", duration = "8 s", seed = seed, set = settings { ["shake.begin"] = "0 s" },
    keep = { built.device.position, built.device.effort_sent },
  }
  assert(#run.faults == 0, run.faults[1])
  local height, effort = {}, {}
  for i = 1, 3 do
    local q = run:samples(built.device.position[axes[i]])
    local u = run:samples(built.device.effort_sent[axes[i]])
    for k = 1, #q do
      height[k] = (height[k] or 0) + q[k] / 3
      effort[k] = (effort[k] or 0) + u[k]
    end
  end
  run:discard()
  local speed, direction = {}, {}
  for k = 2, #height - 1 do
    speed[k] = 0.5 * rate * (height[k + 1] - height[k - 1])
  end
  speed[1], speed[#height] = speed[2], speed[#height - 1]
  for k, v in ipairs(speed) do direction[k] = v > 0 and 1 or v < 0 and -1 or 0 end
  local residual = {}
  for n = 0, longest do
    local columns, target = { {}, {}, {}, {} }, {}
    for k = 4000 + h + longest, #height - h, 5 do
      -- Half of each tick before t_k, half after it.
      local row = #target + 1
      columns[1][row] = 0.5 * (difference.weighted(effort, k - n, h) + difference.weighted(effort, k - n - 1, h))
      columns[2][row] = difference.weighted(speed, k, h)
      columns[3][row] = difference.weighted(direction, k, h)
      columns[4][row] = 1
      target[row] = difference.of(height, k, h, rate)
    end
    residual[n] = trocar.least_squares { columns = columns, target = target }.rms ^ 2
  end
  local best = 0
  for n = 1, longest do if residual[n] < residual[best] then best = n end end
  local part = 0
  if best > 0 and best < longest then
    local before, at, after = residual[best - 1], residual[best], residual[best + 1]
    part = 0.5 * (before - after) / (before - 2 * at + after)
  end
  return (best + part) / rate
end

-- Everything of one device.
-- @return gain {6}, dry {6} [N, N m], viscous {6} [N s/m, N m s/rad], masses [kg, m], delay [s]
function identification.of(built, seed)
  local fit = statics_of(built, seed)
  local theta, found = fit.solution, { gain = {}, dry = {}, viscous = {}, rms = fit.rms }
  for i = 1, 6 do
    local own = #drawn + 3 * (i - 1)
    found.gain[i] = theta[own + 1]
    found.dry[i] = math.max(0, theta[own + 2])
    found.viscous[i] = math.max(0, theta[own + 3])
  end
  local tool = theta[1] - nominal.platform - 1.5 * nominal.link
  found.masses = { tool_mass = tool, tool_centre = theta[2] / tool, gimbal_mass = theta[3],
    slider_mass = theta[4] - 0.5 * nominal.link, pin_mass = theta[5] }
  found.delay = delay_of(built, seed)
  return found
end

-- What a device leaves unexplained of its balance [N, root mean square]: by the drawing, without
-- friction and with gains of 1, and by what was identified.
function identification.residual(built, seed, found)
  local columns, target = equations(built, seed)
  local tool = found.masses.tool_mass
  local by_drawing = { table.unpack(drawn) }
  local identified = { nominal.platform + 1.5 * nominal.link + tool, tool * found.masses.tool_centre,
    found.masses.gimbal_mass, found.masses.slider_mass + 0.5 * nominal.link, found.masses.pin_mass }
  for i = 1, 6 do
    for _, value in ipairs { 1, 0, 0 } do by_drawing[#by_drawing + 1] = value end
    for _, field in ipairs { "gain", "dry", "viscous" } do
      identified[#identified + 1] = found[field][i]
    end
  end
  local function left(theta)
    local squares = 0
    for n, wanted in ipairs(target) do
      for c, column in ipairs(columns) do wanted = wanted - theta[c] * column[n] end
      squares = squares + wanted ^ 2
    end
    return math.sqrt(squares / #target)
  end
  return left(by_drawing), left(identified)
end

-- The mean of `count` devices, seeds 101 and on, and how much they differ.
function identification.mean(built, count)
  local devices, mean = {}, { seeds = {} }
  for seed = 101, 100 + count do
    devices[#devices + 1] = identification.of(built, seed)
    mean.seeds[#mean.seeds + 1] = seed
  end
  for _, field in ipairs { "gain", "dry", "viscous", "masses" } do
    mean[field], mean[field .. "_spread"] = {}, {}
    for key in pairs(devices[1][field]) do
      local values = statistics.column(statistics.column(devices, field), key)
      mean[field][key] = statistics.mean(values)
      mean[field .. "_spread"][key] = statistics.spread(values)
    end
  end
  mean.devices = devices
  mean.delay = statistics.mean(statistics.column(devices, "delay"))
  return mean
end

return identification
