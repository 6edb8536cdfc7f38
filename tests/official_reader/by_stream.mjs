// SPDX-License-Identifier: Apache-2.0
import { McapStreamReader } from "@mcap/core";
import { makeDecoder } from "./decoder.mjs";
import { Tally } from "./sums.mjs";

/** Keeps what the data section holds; records of the summary go to `summary`. */
class Reading {
  schemas = new Map();
  channels = new Map();
  topics = new Map(); // channel id -> { count, payloadBytes, first, last, ... }
  attachments = [];
  metadata = [];
  tally = new Tally();
  indexed = new Map(); // channel id -> entries in message indexes
  chunkCount = 0;
  messageCount = 0;
  payloadBytes = 0;
  header;
  dataEnd;
  footer;
  summary = { schemas: new Map(), channels: new Map(), statistics: undefined };
  #decoders = new Map();

  take(record) {
    const home = this.dataEnd === undefined ? this : this.summary;
    switch (record.type) {
      case "Header": this.header = record; break;
      case "Schema": home.schemas.set(record.id, record); break;
      case "Channel": home.channels.set(record.id, record); break;
      case "Message": this.#message(record); break;
      case "Chunk": this.chunkCount += 1; break;
      case "MessageIndex": this.#index(record); break;
      case "Attachment": this.attachments.push(record); break;
      case "Metadata": this.metadata.push(record); break;
      case "DataEnd": this.dataEnd = record; break;
      case "Statistics": this.summary.statistics = record; break;
      case "Footer": this.footer = record; break;
    }
  }

  #message(message) {
    const channel = this.channels.get(message.channelId);
    if (!this.#decoders.has(channel.id)) {
      this.#decoders.set(channel.id, makeDecoder(channel, this.schemas.get(channel.schemaId)));
      this.topics.set(channel.id, { topic: channel.topic, count: 0, payloadBytes: 0 });
    }
    const decoded = this.#decoders.get(channel.id)(message);
    const entry = this.topics.get(channel.id);
    const noted = { sequence: message.sequence, logTime: message.logTime, message: decoded };
    entry.first ??= noted;
    entry.last = noted;
    entry.count += 1;
    entry.payloadBytes += message.data.length;
    this.payloadBytes += message.data.length;
    this.messageCount += 1;
    this.tally.add(message);
  }

  #index({ channelId, records }) {
    this.indexed.set(channelId, (this.indexed.get(channelId) ?? 0) + records.length);
  }
}

/** Reads the file from front to back, with all checksums validated. */
export async function readByStream(file) {
  const reader = new McapStreamReader({ includeChunks: true, validateCrcs: true });
  const reading = new Reading();
  for await (const piece of file.pieces(0n, await file.size())) {
    reader.append(piece);
    for (let record; (record = reader.nextRecord()); ) reading.take(record);
  }
  if (!reader.done()) throw new Error("the file ends early: there is no footer");
  return reading;
}
