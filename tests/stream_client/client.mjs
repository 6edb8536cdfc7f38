// SPDX-License-Identifier: Apache-2.0
// Reads a run of `trocar run --serve` with the official client and compares it with the run's log:
// node client.mjs URL LOG.mcap SECONDS
import { open } from "node:fs/promises";
import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import foxglove from "@foxglove/ws-protocol";
import { McapStreamReader } from "@mcap/core";
import { WebSocket } from "ws";

const [url, log, seconds] = process.argv.slice(2);
const insist = (condition, what) => {
  if (!condition) throw new Error(what);
};
const key = (value) => JSON.stringify(value, (_, v) => (typeof v === "bigint" ? `${v}n` : v));

/** What was received of each topic, decoded by its schema. */
const received = new Map();
const topics = new Map(); // by subscription
const client = new foxglove.FoxgloveClient({
  ws: new WebSocket(url, [foxglove.FoxgloveClient.SUPPORTED_SUBPROTOCOL]),
});
const once = (event, accept = () => true) =>
  new Promise((resolve) => {
    const listener = (value) => {
      if (!accept(value)) return;
      client.off(event, listener);
      resolve(value);
    };
    client.on(event, listener);
  });

client.on("error", (error) => {
  throw error;
});
client.on("status", (status) => console.log(`status ${status.level}: ${status.message}`));
client.on("advertise", (channels) => {
  for (const channel of channels) {
    const decode =
      channel.encoding === "json"
        ? (data) => JSON.parse(new TextDecoder().decode(data))
        : reader(channel);
    topics.set(client.subscribe(channel.id), { topic: channel.topic, decode });
    received.set(channel.topic, []);
  }
});
client.on("message", (message) => {
  const { topic, decode } = topics.get(message.subscriptionId);
  received.get(topic).push(decode(message.data));
});

function reader(channel) {
  const messages = new MessageReader(parse(channel.schema, { ros2: true }));
  return (data) => {
    const decoded = messages.readMessage(data);
    insist(!messages.lastReadHadTrailingBytes(), `${channel.topic}: bytes are left over`);
    return decoded;
  };
}

let services = [];
let calls = 0;
client.on("advertiseServices", (offered) => (services = services.concat(offered)));
async function call(name, argument = {}) {
  const service = services.find((one) => one.name === name);
  insist(service, `no service ${name}`);
  const callId = ++calls;
  const answer = Promise.race([
    once("serviceCallResponse", (one) => one.callId === callId),
    once("serviceCallFailure", (one) => one.callId === callId).then((one) => {
      throw new Error(`${name}: ${one.message}`);
    }),
  ]);
  const data = new TextEncoder().encode(JSON.stringify(argument));
  client.sendServiceCallRequest({ serviceId: service.id, callId, encoding: "json", data });
  return JSON.parse(new TextDecoder().decode((await answer).data));
}

async function readLog(file) {
  const rows = [];
  const schemas = new Map();
  const decoders = new Map();
  const mcap = new McapStreamReader();
  const handle = await open(file);
  mcap.append(new Uint8Array(await handle.readFile()));
  await handle.close();
  for (let record; (record = mcap.nextRecord()); ) {
    if (record.type === "Schema") schemas.set(record.id, record);
    if (record.type === "Channel" && record.topic === "/main") {
      const text = new TextDecoder().decode(schemas.get(record.schemaId).data);
      decoders.set(record.id, new MessageReader(parse(text, { ros2: true })));
    }
    if (record.type === "Message" && decoders.has(record.channelId))
      rows.push(decoders.get(record.channelId).readMessage(record.data));
  }
  return rows;
}

const rest = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
async function until(condition, what) {
  for (let i = 0; i < 1000; ++i)
    if (condition()) return;
    else await rest(20);
  throw new Error(`not within 20 s: ${what}`);
}

let info;
client.on("serverInfo", (told) => (info = told));
await until(() => info && services.length > 0, "welcome");
insist(info.name === "Trocar", `a server called ${info.name}`);
await call("start");
await until(() => received.get("/main")?.length > 0, "a row");

const changed = once("parameterValues", (one) => one.id === "set");
client.setParameters([{ name: "wall.stiffness", value: 2500 }], "set");
insist((await changed).parameters[0].value === 2500, "wall.stiffness is not 2500 N/m");
await rest(1000 * Number(seconds));
await call("annotate", { text: "seen by the official client" });
insist((await call("stop")).asked === "stop", "stop was not taken");
await rest(300);
await call("end");
await until(() => received.get("/trocar/state")?.at(-1)?.running === false, "the end");
await rest(100);
client.close();

const rows = new Map((await readLog(log)).map((row) => [Number(row.tick), key(row)]));
const single = received.get("/main");
const batched = received.get("/main/batch").flatMap((batch) => batch.rows);
for (const [form, list] of [["single", single], ["batched", batched]])
  for (const row of list)
    insist(rows.get(Number(row.tick)) === key(row), `tick ${row.tick}, ${form}: the log has it otherwise`);
const first = Number(single[0].tick);
insist(single.length === rows.size - first, `${single.length} rows of ${rows.size - first}`);
insist(batched.length >= single.length - 100, `${batched.length} rows in batches`);
const previews = received.get("/main/preview");
insist(previews.length > 20 * Number(seconds), `${previews.length} previews`);
const kinds = received.get("/events").map((event) => event.kind);
for (const kind of ["started", "edit", "annotated", "ended"]) insist(kinds.includes(kind), `no event ${kind}`);
console.log(
  `${single.length} rows, ${batched.length} in batches, ${previews.length} previews, ` +
    `${kinds.length} events: all decoded, and the rows are those of the log`,
);
process.exit(0);
