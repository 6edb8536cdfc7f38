// SPDX-License-Identifier: Apache-2.0
#include "cli/stubs.hpp"

namespace trocar::cli {

std::string_view language_stub() {
  return R"lua(---@meta _
-- Written by `trocar stubs`; changes are lost.

---A text with a unit, "2.2 N/mm". A bare number is dimensionless, or zero.
---@alias trocar.Quantity string|number
---What an input takes: an output that connects, or a value.
---@alias trocar.Source trocar.Output|string|number|boolean|table
---A signal: an output, its name, or run["name"].
---@alias trocar.SignalOf trocar.Output|trocar.Signal|trocar.SignalName
---@alias trocar.Comparison "<"|"<="|"=="|">="|">"

---A parameter; given to another one, it is followed by that.
---@class trocar.Parameter
---An input; outputs connect to it by output:to(input).
---@class trocar.Input

---@class trocar.Rotation
---@field roll? trocar.Quantity
---@field pitch? trocar.Quantity
---@field yaw? trocar.Quantity

---A point of a tool, for `at`.
---@class trocar.Site
---@field position trocar.Output.Vector3
---@field velocity trocar.Output.Vector3
---@field force trocar.Input through motors and gate
---@field moment trocar.Input through motors and gate
---@field load trocar.Input acts on the simulated tool from outside

---An output, or a field of one: a signal. Operators make components.
---@class trocar.Output
---@operator add(trocar.Output): trocar.Output.any
---@operator add(trocar.Quantity): trocar.Output.any
---@operator sub(trocar.Output): trocar.Output.any
---@operator sub(trocar.Quantity): trocar.Output.any
---@operator mul(trocar.Output): trocar.Output.any
---@operator mul(trocar.Quantity): trocar.Output.any
---@operator unm: trocar.Output.any
local Output = {}
---Renames the component that makes it; for what operators and delay have made.
---@generic T : trocar.Output
---@param self T
---@param name string
---@return T
function Output:as(name) end
---Connects it to inputs.
---@generic T : trocar.Output
---@param self T
---@param ... trocar.Input
---@return T
function Output:to(...) end
---What it was some ticks ago: breaks a loop.
---@generic T : trocar.Output
---@param self T
---@param settings { initial: any, ticks?: integer, name?: string }
---@return T
function Output:delay(settings) end
---For another thread: the newest value. Older than `stale`, it is a fault.
---@generic T : trocar.Output
---@param self T
---@param settings? { stale?: trocar.Quantity }
---@return T
function Output:latest(settings) end
---For another thread: each value once and in order.
---@generic T : trocar.Output
---@param self T
---@param settings? { size?: integer, stale?: trocar.Quantity }
---@return T
function Output:queue(settings) end

---@class trocar
---@field args table<string, any> of --set, where the name has no dot
trocar = {}

---@class trocar.RunOptions
---@field rate? trocar.Quantity of the thread main, "1 Hz" to "100 kHz" (1 kHz)
---@field duration? trocar.Quantity --for wins over it (1 s)
---@field seed? integer of everything random; --seed wins (1)
---@field set? trocar.Set parameters for this run; --set wins
---@field edits? trocar.Edit[] live parameters at their times, ramped in 0.2 s
---@field keep? trocar.SignalOf[] only these signals are kept for the results (all)
---@field reloads? trocar.Reload[] laws of files that take over at their times
---@field requests? { at: trocar.Quantity, ask: "stop"|"acknowledge"|"home"|"engage"|"end" }[] an operator's

---A law's new version: the component's name = a file beside the script.
---@class trocar.Reload
---@field at trocar.Quantity
---@field [string] string

---What came of it.
---@class trocar.ReloadVerdict
---@field component string
---@field file string
---@field time number [s]
---@field trouble string why it was refused or given up; "" when it took over

---Runs the graph and waits for the result.
---@param options trocar.RunOptions
---@return trocar.Run
function trocar.run(options) end
---Adds a row to the report, to --json and to the log.
---@param name string
---@param row table
function trocar.publish(name, row) end

---@class trocar.Fit
---@field slope number
---@field offset number
---@field r2 number
---@field inverse_slope number dx/dy of the line of x on y
---@field rms number of what is left
---@field count integer

---What a run came to. Numbers are SI. run["wall.force.z"] is a signal.
---@class trocar.Run
---@field duration number [s]
---@field ticks integer
---@field rate number [Hz]
---@field faults string[] empty when all went well
---@field reloads trocar.ReloadVerdict[]
---@field [string] trocar.Signal
local Run = {}
---Least squares, y = slope x + offset.
---@param what { x: trocar.SignalOf, y: trocar.SignalOf, where?: trocar.SignalOf, from?: trocar.Quantity, to?: trocar.Quantity }
---@return trocar.Fit
function Run:fit(what) end
---The farthest that it gets from its first value; the norm, for a vector.
---@param signal trocar.SignalOf
---@return number
function Run:drift(signal) end
---@param signal trocar.SignalOf a single number
---@return number
function Run:mean(signal) end
---@param signal trocar.SignalOf a single number
---@return number
function Run:rms(signal) end
---@param signal trocar.SignalOf a single number
---@return number
function Run:min(signal) end
---@param signal trocar.SignalOf a single number
---@return number
function Run:max(signal) end
---@param signal trocar.SignalOf a single number
---@return number
function Run:first(signal) end
---@param signal trocar.SignalOf a single number
---@return number
function Run:last(signal) end
---In the last row that is not later.
---@param signal trocar.SignalOf a single number
---@param time trocar.Quantity
---@return number
function Run:at(signal, time) end
---Its number in each row.
---@param signal trocar.SignalOf a single number
---@param which { from?: trocar.Quantity, to?: trocar.Quantity, every?: integer, where?: trocar.SignalOf }
---@return number[]
function Run:samples(signal, which) end
---Gives the rows back to the machine.
function Run:discard() end

---A signal of a run, for expect.
---@class trocar.Signal
local Signal = {}
---The length of a vector.
---@return trocar.Signal
function Signal:norm() end

---The numbers p with y ≈ p1 a + p2 b, by linear least squares.
---@param what { columns: number[][], target: number[] }
---@return { solution: number[], errors: number[], rms: number, r2: number }
function trocar.least_squares(what) end

---A further thread of the loop; what is made through it runs in it.
---@param settings { rate: trocar.Quantity, priority?: integer, processor?: integer, phase?: trocar.Quantity, name?: string }
---@return trocar.Thread
function trocar.thread(settings) end

---@alias trocar.Declared { [1]: any, range?: trocar.Quantity[], doc?: string }

---A constructor of one's own. What `build` returns are the group's members.
---@param definition { name: string, parameters?: table<string, trocar.Declared>, inputs?: string[]|table<string, string>, build: fun(parameters: table<string, trocar.Parameter>, inputs: table<string, any>): table }
---@return fun(settings: table): table
function trocar.group(definition) end

---Another script's graph, described up to its first trocar.run.
---@class trocar.Rig
local Rig = {}
---What the table leaves out is as in the script's first trocar.run.
---@param options? trocar.RunOptions
---@return trocar.Run
function Rig:run(options) end
---@param file string beside this script
---@param settings? trocar.Set as --set takes them
---@return trocar.Rig
function trocar.load(file, settings) end
---Runs another experiment to its end.
---@param file string beside this script
---@param settings? trocar.Set as --set takes them
---@return { runs: trocar.Run[], published: table<string, table[]> }
function trocar.experiment(file, settings) end
)lua";
}

}  // namespace trocar::cli
