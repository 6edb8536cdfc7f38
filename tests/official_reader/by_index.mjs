// SPDX-License-Identifier: Apache-2.0
import { McapIndexedReader } from "@mcap/core";
import { Tally } from "./sums.mjs";

async function checkOrder(reader) {
  let lastTime = 0n;
  for await (const message of reader.readMessages()) {
    if (message.logTime < lastTime) throw new Error("the index does not give the order of log time");
    lastTime = message.logTime;
  }
}

/** Reads the file through its summary and indexes. */
export async function readByIndex(file) {
  const reader = await McapIndexedReader.Initialize({ readable: file });
  await checkOrder(reader);
  const tally = new Tally();
  // Topic by topic: only then does the reader follow each index instead of reading all.
  for (const topic of new Set([...reader.channelsById.values()].map((channel) => channel.topic)))
    for await (const message of reader.readMessages({ topics: [topic] })) tally.add(message);
  const attachments = [];
  for await (const attachment of reader.readAttachments()) attachments.push(attachment);
  const metadata = [];
  for await (const entry of reader.readMetadata()) metadata.push(entry);
  return { reader, tally, attachments, metadata };
}
