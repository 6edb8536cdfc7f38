-- From what was identified to the settings that switch a rig's compensation on.

local compensation = {}

-- How much of the identified friction is taken off: less than all, by more than devices differ.
compensation.share = 0.94

local function with_unit(numbers, first, unit)
  local list = {}
  for i = first, first + 2 do list[#list + 1] = ("%.6g %s"):format(numbers[i], unit) end
  return list
end

-- @param found of identification.mean, or of a file that identify.lua wrote
-- @param what { gain, friction, viscous, weight = false } leaves these out; inertia = true adds it
function compensation.settings(found, what)
  what = what or {}
  local set = {}
  if what.gain ~= false then
    set["drives.gain"] = found.gain
    set["holding.gain"] = found.gain
  end
  if what.friction ~= false then
    set["friction.share"] = compensation.share
    set["friction.slider_dry"] = with_unit(found.dry, 1, "N")
    set["friction.ring_dry"] = with_unit(found.dry, 4, "N m")
  end
  if what.friction ~= false and what.viscous ~= false then
    set["friction.slider_viscous"] = with_unit(found.viscous, 1, "N s/m")
    set["friction.ring_viscous"] = with_unit(found.viscous, 4, "N m s/rad")
  end
  if what.weight ~= false then
    for name, value in pairs(found.masses) do
      set["weight." .. name] = ("%.6g %s"):format(value, name == "tool_centre" and "m" or "kg")
    end
  end
  if what.inertia then
    set["inertia.share"] = 1
    set["ahead.lead"] = ("%.6g s"):format(found.delay)
    for name, value in pairs(found.masses) do
      set["inertia." .. name] = ("%.6g %s"):format(value, name == "tool_centre" and "m" or "kg")
    end
  end
  return set
end

-- What --set identified=FILE names, or nil.
function compensation.given()
  local file = trocar.args.identified
  return file and assert(loadfile(file, "t", {}))()
end

return compensation
