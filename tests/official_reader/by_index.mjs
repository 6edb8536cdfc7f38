// SPDX-License-Identifier: Apache-2.0
import { McapIndexedReader } from "@mcap/core";
import { Tally } from "./sums.mjs";

/** Reads the file through its summary and indexes. */
export async function readByIndex(file) {
  const reader = await McapIndexedReader.Initialize({ readable: file });
  const tally = new Tally();
  let lastTime = 0n;
  for await (const message of reader.readMessages()) {
    if (message.logTime < lastTime) throw new Error("the index does not give the order of log time");
    lastTime = message.logTime;
    tally.add(message);
  }
  const attachments = [];
  for await (const attachment of reader.readAttachments()) attachments.push(attachment);
  const metadata = [];
  for await (const entry of reader.readMetadata()) metadata.push(entry);
  return { reader, tally, attachments, metadata };
}
