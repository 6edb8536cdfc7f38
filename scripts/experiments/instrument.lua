-- What measures beside the device: a dial gauge on the tool and weights on a string. They know
-- where the tool really is, with noise of their own, and belong to the laboratory: no effort and
-- no identification may use them.

local instrument = {
  gauge = 40e-6, -- standard deviation of one reading [m]
  weight = { 0.05, 0.004 }, -- of a load [N], and in proportion to it
}

-- Normal numbers, the same for the same seed.
function instrument.noise(seed)
  math.randomseed(seed)
  return function(deviation)
    local radius = math.sqrt(-2 * math.log(1 - math.random()))
    return deviation * radius * math.cos(2 * math.pi * math.random())
  end
end

-- Where the tip is along an axis: "x", "y" or "z".
function instrument.tip(built, axis) return built.device.truth.tip.position[axis] end

-- What a run has to keep for them.
function instrument.signals(built, staircase)
  return { built.device.truth.tip, staircase.load, staircase.settled }
end

-- One pair of readings for each dwell of a staircase: means over its settled part, then noise.
-- @param readings of the gauge and of the load in each dwell, of which the mean is taken
-- @return lists of displacements [m] and loads [N]
function instrument.read(run, built, staircase, axis, seed, readings)
  local noise = instrument.noise(seed)
  local where = run:samples(instrument.tip(built, axis), { where = staircase.settled })
  local loads = run:samples(staircase.load, { where = staircase.settled })
  local x, force = {}, {}
  local first = 1
  for i = 1, #loads do
    if i == #loads or loads[i + 1] ~= loads[i] then
      local sum = 0
      for k = first, i do sum = sum + where[k] - where[1] end
      local deviation = instrument.weight[1] + instrument.weight[2] * math.abs(loads[i])
      x[#x + 1] = sum / (i - first + 1) + noise(instrument.gauge / math.sqrt(readings))
      force[#force + 1] = loads[i] + noise(deviation / math.sqrt(readings))
      first = i + 1
    end
  end
  return x, force
end

return instrument
