// SPDX-License-Identifier: Apache-2.0
// Judges a log with the readers of its formats' authors: every message is decoded by
// its own schema, and what the index finds is held against what a front-to-back
// reading finds. Exit status 0: sound, 1: not, with the reason; 2: wrong usage.
import { parseArgs } from "node:util";
import { readByIndex } from "./by_index.mjs";
import { readByStream } from "./by_stream.mjs";
import { compare } from "./compare.mjs";
import { openFile } from "./file.mjs";
import { reportJson, reportText } from "./report.mjs";

const usage = `usage: node check.mjs FILE [--json] [--max-ratio R]
  --json         print the result as JSON, with each topic's first and last message
  --max-ratio R  fail when file size / payload bytes is above R, e.g. 1.1`;

function readArguments() {
  try {
    const { values, positionals } = parseArgs({
      allowPositionals: true,
      options: { json: { type: "boolean" }, "max-ratio": { type: "string" } },
    });
    const maxRatio = Number(values["max-ratio"] ?? Infinity);
    if (positionals.length !== 1 || !(maxRatio > 0)) throw new Error("one FILE, and R above 0");
    return { path: positionals[0], json: values.json === true, maxRatio };
  } catch (error) {
    console.error(`${error.message}\n${usage}`);
    process.exit(2);
  }
}

async function check(path, maxRatio) {
  const file = await openFile(path);
  try {
    const stream = await readByStream(file);
    const index = await readByIndex(file);
    await compare(file, stream, index);
    const size = Number(await file.size());
    const ratio = stream.payloadBytes > 0 ? size / stream.payloadBytes : null;
    if (ratio !== null && ratio > maxRatio)
      throw new Error(`the file is ${ratio.toFixed(3)} times its payload, allowed is ${maxRatio}`);
    return { path, size, ratio, stream };
  } finally {
    await file.close();
  }
}

const { path, json, maxRatio } = readArguments();
try {
  const result = await check(path, maxRatio);
  console.log(json ? reportJson(result) : reportText(result));
} catch (error) {
  if (json) console.log(JSON.stringify({ file: path, ok: false, reason: error.message }));
  console.error(`${path}: ${error.message}`);
  process.exit(1);
}
