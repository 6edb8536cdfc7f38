// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/loop_world.hpp"

namespace trocar::lua {

/// Vectors are plain tables with x, y and z, so that a field costs an instruction. What changes one
/// in place allocates nothing; what makes a new one does.
std::string_view loop_vectors_text() {
  return R"lua(
local raw = ...
local setmetatable, type, next, sqrt = raw.setmetatable, raw.type, raw.next, raw.math.sqrt
local refuse = raw.refuse

local in_place, made = {}, {}           -- methods
local vector, read_only = {}, {}        -- metatables: of any vector, and of an input

local function new(x, y, z)
  return setmetatable({ x = x, y = y, z = z }, vector)
end

function in_place.set(v, x, y, z)
  if z then
    v.x = x; v.y = y; v.z = z
  elseif x and not y then
    v.x, v.y, v.z = x.x, x.y, x.z
  elseif type(v) ~= "table" then
    refuse("a method is called with a colon: out.force:set(0, 0, 1)")
  else
    refuse("set takes three numbers or a vector, e.g. out.force:set(0, 0, -1)")
  end
  return v
end
function in_place.add(v, w)
  v.x = v.x + w.x; v.y = v.y + w.y; v.z = v.z + w.z
  return v
end
function in_place.sub(v, w)
  v.x = v.x - w.x; v.y = v.y - w.y; v.z = v.z - w.z
  return v
end
function in_place.scale(v, s)
  v.x = v.x * s; v.y = v.y * s; v.z = v.z * s
  return v
end
function in_place.add_scaled(v, w, s)
  v.x = v.x + s * w.x; v.y = v.y + s * w.y; v.z = v.z + s * w.z
  return v
end
function in_place.set_cross(v, a, b)
  v.x, v.y, v.z = a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x
  return v
end

function made.dot(v, w) return v.x * w.x + v.y * w.y + v.z * w.z end
function made.norm(v) return sqrt(v.x * v.x + v.y * v.y + v.z * v.z) end
function made.cross(a, b)
  return new(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)
end
function made.copy(v) return new(v.x, v.y, v.z) end
for name, method in next, made do in_place[name] = method end

local function needs(what, a, b)
  local odd = type(a) == "table" and b or a
  refuse(what, ", not ", odd == nil and "nil" or type(odd))
end
local function both(a, b)
  return type(a) == "table" and type(b) == "table"
end
local operators = {
  __add = function(a, b)
    if not both(a, b) then needs("a vector and a vector are added", a, b) end
    return new(a.x + b.x, a.y + b.y, a.z + b.z)
  end,
  __sub = function(a, b)
    if not both(a, b) then needs("a vector is taken off a vector", a, b) end
    return new(a.x - b.x, a.y - b.y, a.z - b.z)
  end,
  __mul = function(a, b)
    if type(a) == "number" then return new(a * b.x, a * b.y, a * b.z) end
    if type(b) == "number" then return new(a.x * b, a.y * b, a.z * b) end
    if both(a, b) then refuse("* of two vectors: a:dot(b) is the number, a:cross(b) the vector") end
    needs("a vector is multiplied by a number", a, b)
  end,
  __div = function(a, b)
    if type(b) ~= "number" then needs("a vector is divided by a number", a, b) end
    return new(a.x / b, a.y / b, a.z / b)
  end,
  __unm = function(a) return new(-a.x, -a.y, -a.z) end,
  __tostring = function(v) return raw.format("(%.6g, %.6g, %.6g)", v.x, v.y, v.z) end,
}
for name, operator in next, operators do
  vector[name], read_only[name] = operator, operator
end

local function is_an_input(name)
  return function()
    refuse("an input cannot be changed: local q = at.position:copy() makes a vector that can, and state keeps it")
  end
end
local fixed = {}
for name in next, in_place do fixed[name] = made[name] or is_an_input(name) end

for metatable, methods in next, { [vector] = in_place, [read_only] = fixed } do
  metatable.__index = setmetatable(methods, { __index = raw.no_such("a vector", methods) })
  metatable.__newindex = raw.no_assign("a vector", "it has x, y and z alone")
end

-- Puts what a law assigned to a field of `out` into the vector or record that was there.
local function take(own, given, name, part)
  if type(given) ~= "table" then
    refuse("out.", name, part and "." or "", part or "", " = ", raw.show(given),
           ": give it a vector, out.force:set(0, 0, 1) or out.force = vec(0, 0, 1), or set its fields")
  end
  for key, value in next, own do
    local new_value = given[key]
    if type(value) == "table" then
      take(value, new_value, name, key)
    elseif new_value == nil then
      refuse("out.", name, " has no ", key, " now: a vector is vec(0, 0, 1), not { 0, 0, 1 }")
    else
      own[key] = new_value
    end
  end
end

local function warm_up(depth)
  return depth > 0 and 1 + warm_up(depth - 1) or 0
end

return {
  warm_up = warm_up,
  vec = function(x, y, z)
    if not z then refuse("vec takes three numbers, e.g. vec(0, 0, 1)") end
    return new(x, y, z)
  end,
  take = take,
  vector = function(input) 
    return setmetatable({ x = 0.0, y = 0.0, z = 0.0 }, input and read_only or vector)
  end,
}
)lua";
}

}  // namespace trocar::lua
