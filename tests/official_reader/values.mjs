// SPDX-License-Identifier: Apache-2.0
// Holds what the official reader decoded from good.mcap against what make_logs wrote:
// run.sh --json good.mcap | node values.mjs
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

const log = JSON.parse(readFileSync(0, "utf8"));
const wall = (tick) => ({
  touched: tick % 2 === 0,
  force: { x: 0.001 * tick, y: 0.001 * tick + 1, z: 0.001 * tick + 2 },
});
const row = (tick) => ({
  valid: true,
  tick,
  wall: wall(tick),
  sides: [wall(tick + 1), wall(tick + 2)],
  a_i8: -128,
  a_u8: 255,
  a_i16: -32768,
  a_u16: 65535,
  a_i32: -2147483648,
  a_u32: 4294967295,
  a_u64: "18446744073709551615",
  a_f32: 0.5,
  flags: [false, true, false],
  samples: Array.from({ length: 140 }, (_, i) => tick + 0.01 * i),
});
const event = (tick, kind) => ({ tick, kind, text: "wall.force: 3 N above the limit – größer als erlaubt" });

const [rows, events] = log.topics;
assert.deepEqual(rows.first.message, row(0));
assert.deepEqual(rows.last.message, row(2999));
assert.equal(rows.last.sequence, 2999);
assert.equal(rows.last.logTime, 2999e6);
assert.deepEqual(events.first.message, event(0, ""));
assert.deepEqual(events.last.message, event(2000, "fault"));
assert.deepEqual(log.metadata, [{ name: "run", entries: { clock: "simulated", seed: "7" } }]);
console.log("every value is as written");
