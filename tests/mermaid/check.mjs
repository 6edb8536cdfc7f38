// SPDX-License-Identifier: Apache-2.0
// Reads flowcharts as Mermaid does.
//   check.mjs FILE.md ...          every flowchart of the documents is one
//   check.mjs FILE.mmd FILE.json   `trocar graph` says the same in both formats
//   check.mjs FILE.mmd FILE.txt    the text is that of the only box, to the character
import { readFileSync } from "node:fs";
import { JSDOM } from "jsdom";

const { window } = new JSDOM("");
globalThis.window = window;
globalThis.document = window.document;
const { default: mermaid } = await import("mermaid");

async function read(text) {
  await mermaid.parse(text);
  return (await mermaid.mermaidAPI.getDiagramFromText(text)).db;
}

function equal(what, found, wanted) {
  const [a, b] = [found, wanted].map((list) => JSON.stringify([...list].sort(), null, 1));
  if (a !== b) throw new Error(`${what}: Mermaid reads ${a}\nwhere the graph has ${b}`);
}

// Mermaid puts these marks in the place of "#" and ";" until it draws.
const decoded = (text) =>
  text.replace(/ﬂ°°(\d+)¶ß/g, (_, code) => String.fromCodePoint(Number(code)));
const id = (kind, name) => `${kind}-${name.replaceAll(/[. ]/g, "-")}`;

const way = (connection) => !connection ? "" : `, ${connection.kind}` +
  (connection.stale === null ? "" : `, stale ${1e3 * connection.stale} ms`);

function compare(db, graph) {
  const devices = graph.nodes.filter((node) => node.device).map((node) => node.name);
  const gated = (wire) =>
    devices.includes(wire.target.node) && ["hold", "effort"].includes(wire.target.input);
  const gates = devices.filter((name) =>
    graph.wires.some((wire) => gated(wire) && wire.target.node === name));
  equal("boxes", db.getVertices().keys(), [
    ...graph.nodes.map((node) => id("node", node.name)), ...gates.map((name) => id("gate", name))]);
  for (const node of graph.nodes) {
    const label = decoded(db.getVertices().get(id("node", node.name)).text);
    if (!label.includes(`<br>${node.type}`)) throw new Error(`${node.name} is called ${label}`);
  }
  const groups = graph.groups.filter((group) =>
    [...graph.nodes, ...graph.groups].some((inner) => inner.group === group.name));
  // Threads are drawn where there are several; a group lies in the thread of its parts.
  const used = [...new Set(graph.nodes.map((node) => node.thread))];
  const threads = used.length > 1 ? used.map((name) => `thread ${name}`) : [];
  const thread_of = (group) => graph.nodes.find((node) => node.group === group.name)?.thread;
  const outside = (part, thread) => part.group ?? (threads.length ? `thread ${thread}` : null);
  equal("clusters", db.getSubGraphs().map((cluster) => cluster.id),
    [...groups.map((group) => group.name), ...threads].map((name) => id("group", name)));
  for (const cluster of db.getSubGraphs()) {
    const inside = (name) => name !== null && id("group", name) === cluster.id;
    equal(cluster.id, cluster.nodes, [
      ...graph.nodes.filter((node) => inside(outside(node, node.thread)))
        .map((node) => id("node", node.name)),
      ...groups.filter((group) => inside(outside(group, thread_of(group))))
        .map((group) => id("group", group.name)),
      ...graph.nodes.filter((node) => gates.includes(node.name) && threads.length &&
          inside(`thread ${node.thread}`))
        .map((node) => id("gate", node.name))]);
  }
  const wires = graph.wires.map((wire) => {
    const field = wire.source.field ? `.${wire.source.field}` : "";
    const from = wire.source.output + field;
    return [id("node", wire.source.node), id(gated(wire) ? "gate" : "node", wire.target.node),
      wire.connection ? "thick" : wire.feedthrough ? "normal" : "dotted",
      (from === wire.target.input ? from : `${from} → ${wire.target.input}`) +
        way(wire.connection)].join(" ");
  });
  const drawn = db.getEdges().flatMap((edge) => decoded(edge.text).split("<br>").map((label) =>
    [edge.start, edge.end, edge.stroke, label.split(": ")[0]].join(" ")));
  equal("arrows", drawn, [...wires, ...gates.map((name) =>
    `${id("gate", name)} ${id("node", name)} dotted GatedEffort`)]);
}

async function check(files) {
  if (files[0].endsWith(".md")) {
    let charts = 0;
    for (const file of files)
      for (const [, text] of readFileSync(file, "utf8").matchAll(/^```mermaid\n(.*?)^```/gms)) {
        await read(text).catch((error) => { throw new Error(`${file}: ${error.message}`); });
        charts += 1;
      }
    if (charts === 0) throw new Error("there is no flowchart in these documents");
    return `${charts} flowcharts`;
  }
  const [picture, other] = files.map((file) => readFileSync(file, "utf8"));
  const db = await read(picture);
  if (files[1].endsWith(".json")) {
    compare(db, JSON.parse(other));
  } else {
    const html = decoded([...db.getVertices().values()][0].text).replace(/^<b>(.*)<\/b>$/, "$1");
    equal("text", [html], [other]);
  }
  return files[0];
}

try {
  console.log(`sound: ${await check(process.argv.slice(2))}`);
} catch (error) {
  console.error(error.message);
  process.exitCode = 1;
}
