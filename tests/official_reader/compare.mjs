// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { crc32Final, crc32Init, crc32Update } from "@foxglove/crc";

function same(what, found, expected) {
  try {
    assert.deepEqual(found, expected);
  } catch {
    const text = (value) => {
      const json = JSON.stringify(value, (_, v) => (typeof v === "bigint" ? `${v}` : v)) ?? "nothing";
      return json.length > 80 ? `${json.slice(0, 80)}…` : json;
    };
    throw new Error(`${what}: ${text(found)} is not ${text(expected)}`);
  }
}

function compareMessages(stream, index) {
  same("channels with messages, by index", index.tally.channels().sort(), stream.tally.channels().sort());
  for (const id of stream.tally.channels()) {
    const { topic } = stream.channels.get(id);
    same(`${topic}: messages found by index`, index.tally.count(id), stream.tally.count(id));
    same(`${topic}: contents found by index`, index.tally.sum(id), stream.tally.sum(id));
    same(`${topic}: entries of message indexes`, stream.indexed.get(id), stream.tally.count(id));
  }
}

function compareStatistics(stream, index) {
  const stated = stream.summary.statistics;
  if (stated === undefined) throw new Error("there are no statistics");
  same("statistics: messages", stated.messageCount, BigInt(stream.messageCount));
  same("statistics: schemas", stated.schemaCount, stream.schemas.size);
  same("statistics: channels", stated.channelCount, stream.channels.size);
  same("statistics: attachments", stated.attachmentCount, stream.attachments.length);
  same("statistics: metadata", stated.metadataCount, stream.metadata.length);
  same("statistics: chunks", stated.chunkCount, stream.chunkCount);
  same("chunk indexes", index.reader.chunkIndexes.length, stream.chunkCount);
  for (const id of stream.channels.keys())
    same(`statistics: messages of channel ${id}`, Number(stated.channelMessageCounts.get(id) ?? 0n), stream.tally.count(id));
  const starts = index.reader.chunkIndexes.map((chunk) => chunk.messageStartTime);
  const ends = index.reader.chunkIndexes.map((chunk) => chunk.messageEndTime);
  const least = (times, before) => times.reduce((a, b) => (before(b, a) ? b : a), times[0] ?? 0n);
  same("statistics: first time", stated.messageStartTime, least(starts, (a, b) => a < b));
  same("statistics: last time", stated.messageEndTime, least(ends, (a, b) => a > b));
}

/** Each group's offset leads to records of its kind, and the groups fill the summary. */
async function checkSummaryOffsets(file, { reader }) {
  const { summaryStart, summaryOffsetStart } = reader.footer;
  const groups = [...reader.summaryOffsetsByOpcode.values()].sort((a, b) => (a.groupStart < b.groupStart ? -1 : 1));
  let end = summaryStart;
  for (const { groupStart, groupLength, groupOpcode } of groups) {
    same("start of a summary group", groupStart, end);
    same("kind of a summary group", (await file.read(groupStart, 1n))[0], groupOpcode);
    end = groupStart + groupLength;
  }
  same("end of the summary groups", end, summaryOffsetStart);
}

async function checkDataCrc(file, { reader }) {
  let crc = crc32Init();
  for await (const piece of file.pieces(0n, reader.dataEndOffset)) crc = crc32Update(crc, piece);
  same("checksum of the data section", crc32Final(crc), reader.dataSectionCrc);
}

/** Throws for the first thing in which the two readings differ. */
export async function compare(file, stream, index) {
  compareMessages(stream, index);
  compareStatistics(stream, index);
  same("schemas in the summary", stream.summary.schemas, stream.schemas);
  same("channels in the summary", stream.summary.channels, stream.channels);
  same("attachment indexes", index.reader.attachmentIndexes.length, stream.attachments.length);
  same("attachments by index", index.attachments, stream.attachments);
  same("metadata by index", index.metadata, stream.metadata);
  await checkSummaryOffsets(file, index);
  await checkDataCrc(file, index);
}
