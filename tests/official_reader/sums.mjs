// SPDX-License-Identifier: Apache-2.0
import { crc32 } from "@foxglove/crc";

/**
 * Counts messages by channel, with a sum that does not depend on their order:
 * two readings found the same messages when their tallies are equal.
 */
export class Tally {
  #channels = new Map();

  add(message) {
    const { channelId, sequence, logTime, publishTime, data } = message;
    const head = new TextEncoder().encode(`${sequence} ${logTime} ${publishTime} ${crc32(data)}`);
    const entry = this.#channels.get(channelId) ?? { count: 0, sum: 0 };
    entry.count += 1;
    entry.sum = (entry.sum + crc32(head)) % Number.MAX_SAFE_INTEGER;
    this.#channels.set(channelId, entry);
  }
  channels() {
    return [...this.#channels.keys()];
  }
  count(channelId) {
    return this.#channels.get(channelId)?.count ?? 0;
  }
  sum(channelId) {
    return this.#channels.get(channelId)?.sum ?? 0;
  }
}
