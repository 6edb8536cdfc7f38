// SPDX-License-Identifier: Apache-2.0

/** JSON knows neither 64-bit integers nor NaN nor typed arrays. */
function plain(_, value) {
  if (typeof value === "bigint") return Number.isSafeInteger(Number(value)) ? Number(value) : `${value}`;
  if (typeof value === "number" && !Number.isFinite(value)) return `${value}`;
  return ArrayBuffer.isView(value) ? [...value] : value;
}

function summaryOf({ path, size, ratio, stream }) {
  return {
    file: path,
    ok: true,
    profile: stream.header.profile,
    library: stream.header.library,
    size,
    payload_bytes: stream.payloadBytes,
    ratio,
    messages: stream.messageCount,
    chunks: stream.chunkCount,
    first_time_ns: stream.summary.statistics.messageStartTime,
    last_time_ns: stream.summary.statistics.messageEndTime,
    topics: [...stream.topics.values()],
    attachments: stream.attachments.map(({ name, mediaType, data }) => ({ name, media_type: mediaType, size: data.length })),
    metadata: stream.metadata.map(({ name, metadata }) => ({ name, entries: Object.fromEntries(metadata) })),
  };
}

export function reportJson(result) {
  return JSON.stringify(summaryOf(result), plain, 2);
}

export function reportText(result) {
  const summary = summaryOf(result);
  const seconds = (time) => `${(Number(time) / 1e9).toFixed(6)} s`;
  const ratio = summary.ratio === null ? "" : `, ${summary.ratio.toFixed(4)} times the payload`;
  return [
    `${summary.file}: sound (${summary.library})`,
    `  ${summary.messages} messages in ${summary.chunks} chunks, ${summary.size} bytes${ratio}`,
    ...summary.topics.map(({ topic, count, first, last }) =>
      `  ${topic}: ${count} messages, ${seconds(first.logTime)} to ${seconds(last.logTime)}`),
    ...summary.attachments.map(({ name, media_type, size }) => `  attachment ${name}: ${media_type}, ${size} bytes`),
    ...summary.metadata.map(({ name, entries }) => `  metadata ${name}: ${Object.keys(entries).length} entries`),
  ].join("\n");
}
