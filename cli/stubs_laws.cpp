// SPDX-License-Identifier: Apache-2.0
#include "cli/stubs.hpp"

namespace trocar::cli {

std::string_view laws_stub() {
  return R"lua(---@meta _
-- Written by `trocar stubs`; changes are lost.

---The file's own parameters and inputs are keys too.
---@class trocar.Law.Settings
---@field file string beside the script
---@field at? trocar.Site of a LuaFixture
---@field name? string
---@field rate? trocar.Quantity
---@field phase? integer
---@field thread? trocar.Thread
---@field instructions? integer of one step (10000)
---@field deadline? trocar.Quantity of one step, in real time (a fifth of the period)
---@field memory? integer KiB that it may hold (512)
---@field strict? boolean a step that allocates is an error (false)
---@field [string] any

---The file's own outputs, parameters and inputs are fields too.
---@class trocar.Law
---@field force trocar.Output.Vector3 of a LuaFixture
---@field script { time: trocar.Output.double, allocations: trocar.Output.int64, memory: trocar.Output.int64 }
---@field [string] any

---A force law in Lua, of a file that returns trocar.fixture { … }.
---@param settings trocar.Law.Settings
---@return trocar.Law
function trocar.LuaFixture(settings) end
---A component in Lua, of a file that returns trocar.component { … }.
---@param settings trocar.Law.Settings
---@return trocar.Law
function trocar.LuaComponent(settings) end

---What a port of a law is: "m", "Vector3 [N] in device", or a table with such a text first.
---@alias trocar.Law.Port string|{ [1]: string, doc?: string, optional?: boolean, labels?: string[] }

---@class trocar.Law.Tick
---@field time number [s]
---@field dt number [s]

---@class trocar.Law.Definition
---@field parameters? table<string, trocar.Declared>
---@field inputs? table<string, trocar.Law.Port>
---@field outputs? table<string, trocar.Law.Port>
---@field state? table kept from step to step, with what it is at first
---@field step fun(p: table, at: table, out: table, state: table, tick: trocar.Law.Tick)

---A force law that steps in the loop. Numbers are SI; outputs begin each step at 0.
---@param definition trocar.Law.Definition
---@return trocar.Law.Definition
function trocar.fixture(definition) end
---The same without a site; `at` holds its inputs.
---@param definition trocar.Law.Definition
---@return trocar.Law.Definition
function trocar.component(definition) end

---A vector in a law.
---@class trocar.Vector
---@field x number
---@field y number
---@field z number
---@operator add(trocar.Vector): trocar.Vector
---@operator sub(trocar.Vector): trocar.Vector
---@operator mul(number): trocar.Vector
---@operator div(number): trocar.Vector
---@operator unm: trocar.Vector
local Vector = {}
---In place, without memory.
---@overload fun(self: trocar.Vector, w: trocar.Vector): trocar.Vector
---@param x number
---@param y number
---@param z number
---@return trocar.Vector
function Vector:set(x, y, z) end
---In place, without memory.
---@param w trocar.Vector
---@return trocar.Vector
function Vector:add(w) end
---In place, without memory.
---@param w trocar.Vector
---@return trocar.Vector
function Vector:sub(w) end
---In place, without memory.
---@param s number
---@return trocar.Vector
function Vector:scale(s) end
---In place, without memory: v + s w.
---@param w trocar.Vector
---@param s number
---@return trocar.Vector
function Vector:add_scaled(w, s) end
---In place, without memory: a × b.
---@param a trocar.Vector
---@param b trocar.Vector
---@return trocar.Vector
function Vector:set_cross(a, b) end
---@param w trocar.Vector
---@return number
function Vector:dot(w) end
---@return number
function Vector:norm() end
---A new vector, which allocates.
---@param b trocar.Vector
---@return trocar.Vector
function Vector:cross(b) end
---A new vector, which allocates.
---@return trocar.Vector
function Vector:copy() end
---A new vector in a law, which allocates.
---@param x number
---@param y number
---@param z number
---@return trocar.Vector
function vec(x, y, z) end
)lua";
}

}  // namespace trocar::cli
