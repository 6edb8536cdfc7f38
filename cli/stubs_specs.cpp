// SPDX-License-Identifier: Apache-2.0
#include "cli/stubs.hpp"

namespace trocar::cli {

std::string_view specs_stub() {
  return R"lua(---@meta _
-- Written by `trocar stubs`; changes are lost.

---A part of a spec, of a file named *_spec.lua.
---@param name string
---@param body fun()
function describe(name, body) end
---A test.
---@param name string
---@param body fun()
function it(name, body) end
---Before each test of this describe.
---@param body fun()
function before_each(body) end
---What is to be judged: a signal of a run, or a value.
---@param subject any
---@return trocar.Expectation
function expect(subject) end

---@alias trocar.Span { from?: trocar.Quantity, to?: trocar.Quantity }

---@class trocar.Expectation
local Expectation = {}
---Of a signal: every row compares so.
---@param comparison trocar.Comparison
---@param bound trocar.Quantity
---@param options? trocar.Span
function Expectation:always(comparison, bound, options) end
---Of a signal: some row compares so.
---@param comparison trocar.Comparison
---@param bound trocar.Quantity
---@param options? { before?: trocar.Quantity, from?: trocar.Quantity, to?: trocar.Quantity }
function Expectation:eventually(comparison, bound, options) end
---Of a signal: every row is between the two, or at one of them.
---@param low trocar.Quantity
---@param high trocar.Quantity
---@param options? trocar.Span
function Expectation:within(low, high, options) end
---Of a signal: it reaches a band and stays there.
---@param target trocar.Quantity
---@param options? { before?: trocar.Quantity, within?: trocar.Quantity, from?: trocar.Quantity, to?: trocar.Quantity }
function Expectation:settles(target, options) end
---Of a signal: its highest value is there; its lowest one, for a negative value.
---@param target trocar.Quantity
---@param options { within: trocar.Quantity, from?: trocar.Quantity, to?: trocar.Quantity }
function Expectation:peaks(target, options) end
---Of a signal: it gets across as often; without `times` at least once.
---@param level trocar.Quantity
---@param options? { times?: integer, way?: "up"|"down", before?: trocar.Quantity, from?: trocar.Quantity, to?: trocar.Quantity }
function Expectation:crosses(level, options) end
---Of a force: the work that it has done along a velocity, in every row.
---@param comparison trocar.Comparison
---@param bound trocar.Quantity
---@param options { velocity: trocar.Signal, from?: trocar.Quantity, to?: trocar.Quantity }
function Expectation:energy(comparison, bound, options) end
---They are the same; tables part by part.
---@param other any
function Expectation:equals(other) end
---The number, in SI, compares so.
---@param comparison trocar.Comparison
---@param bound trocar.Quantity
function Expectation:is(comparison, bound) end
---The number, in SI, is near.
---@param target trocar.Quantity
---@param options { within: trocar.Quantity }
function Expectation:near(target, options) end
---A table or a text is empty.
function Expectation:empty() end
---A text has it in it; a list has a text that does.
---@param text string
function Expectation:contains(text) end
---A function raises an error with that text.
---@param text? string
function Expectation:fails(text) end
)lua";
}

}  // namespace trocar::cli
