// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/loop_world.hpp"

namespace trocar::lua {

/// What scripts see of Lua's own library. What Lua has in C with a cost that grows is written in
/// Lua here, so that it counts as what it is.
std::string_view loop_library_text() {
  return R"lua(
local raw, vectors = ...
local next, type, refuse = raw.next, raw.type, raw.refuse
local longest = raw.longest_text

-- string: what needs no pattern; the rest is refused by name.
local string = {}
for _, name in raw.ipairs { "byte", "char", "len", "lower", "reverse", "sub", "upper" } do
  string[name] = raw.string[name]
end
string.format = raw.format
function string.rep(text, n, between)
  if n > longest or (#text + #(between or "")) * n > longest then
    refuse("string.rep: a text is at most ", longest, " bytes")
  end
  return raw.string.rep(text, n, between)
end

-- table
local table = {}
function table.insert(list, at, ...)
  if raw.select("#", ...) == 0 then
    list[#list + 1] = at
    return
  end
  local value = ...
  for i = #list, at, -1 do list[i + 1] = list[i] end
  list[at] = value
end
function table.remove(list, at)
  local n = #list
  at = at or n
  local value = list[at]
  for i = at, n - 1 do list[i] = list[i + 1] end
  if at <= n then list[n] = nil end
  return value
end
function table.concat(list, between, first, last)
  local text = ""
  for i = first or 1, last or #list do
    text = text .. (text == "" and "" or between or "") .. list[i]
  end
  return text
end
function table.unpack(list, first, last)
  first, last = first or 1, last or #list
  if last - first >= 100 then refuse("table.unpack: at most 100 values") end
  return raw.table.unpack(list, first, last)
end
local function less(a, b) return a < b end
-- Heapsort: in place, n log n in every case, whatever the comparison says.
local function sift(list, top, n, before)
  while 2 * top <= n do
    local child = 2 * top
    if child < n and before(list[child], list[child + 1]) then child = child + 1 end
    if not before(list[top], list[child]) then return end
    list[top], list[child] = list[child], list[top]
    top = child
  end
end
function table.sort(list, before)
  before = before or less
  for top = #list // 2, 1, -1 do sift(list, top, #list, before) end
  for n = #list, 2, -1 do
    list[1], list[n] = list[n], list[1]
    sift(list, 1, n - 1, before)
  end
end

local math = {}
for name, value in next, raw.math do math[name] = value end
math.randomseed = nil

-- pairs: 1 to n, then names alphabetically; other keys have no order.
local function pairs(t)
  if type(t) ~= "table" then refuse("pairs needs a table, not ", raw.show(t)) end
  local keys, names = {}, {}
  for i = 1, #t do keys[i] = i end
  for key in next, t do
    if type(key) == "string" then
      names[#names + 1] = key
    elseif raw.math.type(key) ~= "integer" or key < 1 or key > #t then
      refuse("pairs: keys are 1 to n and names: others have no order")
    end
  end
  raw.sort_names(names)
  for i = 1, #names do keys[#keys + 1] = names[i] end
  local i = 0
  return function()
    i = i + 1
    local key = keys[i]
    if key ~= nil then return key, t[key] end
  end
end

local function tostring(value)
  local kind = type(value)
  if kind == "table" and not raw.has_text(value) or kind == "function" then return kind end
  return raw.tostring(value)
end

local world = {
  assert = raw.assert, error = raw.error, ipairs = raw.ipairs, pcall = raw.pcall,
  select = raw.select, tonumber = raw.tonumber, type = type,
  pairs = pairs, tostring = tostring,
  math = math, string = string, table = table, vec = vectors.vec,
}

local no_file = "nothing in the loop reaches a file or the machine"
local cures = {
  io = no_file, os = no_file, package = no_file, require = no_file, dofile = no_file, loadfile = no_file,
  load = "the loop runs what the file says, and nothing else",
  loadstring = "the loop runs what the file says, and nothing else",
  debug = "errors come with their lines",
  print = "declare an output, outputs = { depth = \"m\" }: its signal shows every tick",
  xpcall = "pcall is there, and errors come with their lines",
  coroutine = "keep what lasts in state, and step from there",
  collectgarbage = "the collector runs in the slack after the tick",
  setmetatable = "write functions that take a table",
  getmetatable = "write functions that take a table",
  rawget = "use t.name", rawset = "use t.name = value", rawlen = "use #t", rawequal = "use ==",
  next = "use pairs", utf8 = "use string", _G = "use local",
}
local no_pattern = "patterns are not for the loop: compare with ==, cut with string.sub"
local string_cures = {
  find = no_pattern, match = no_pattern, gmatch = no_pattern, gsub = no_pattern,
  dump = "the loop runs what the file says, and nothing else",
  pack = "use numbers", unpack = "use numbers", packsize = "use numbers",
}
local table_cures = { move = "use a loop", pack = "write { … }" }
local math_cures = {
  randomseed = "the run's seed is math.random's: trocar run --seed",
  atan2 = "use math.atan(y, x)",
}
for owner, guarded in next, { [""] = { world, cures }, ["string"] = { string, string_cures },
                             ["table"] = { table, table_cures }, ["math"] = { math, math_cures } } do
  raw.setmetatable(guarded[1], {
    __index = raw.no_such(owner, guarded[1], guarded[2]),
    __newindex = raw.no_assign(owner, owner == "" and "write local, or keep it in state" or "it stays as it is"),
  })
end
raw.string_metatable.__index = string
return world
)lua";
}

}  // namespace trocar::lua
