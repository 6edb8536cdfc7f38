// SPDX-License-Identifier: Apache-2.0
import { open } from "node:fs/promises";

/** A file in the form that McapIndexedReader asks for (IReadable). */
export async function openFile(path) {
  const handle = await open(path, "r");
  const size = BigInt((await handle.stat()).size);

  async function read(offset, length) {
    if (offset < 0n || length < 0n || offset + length > size)
      throw new Error(`bytes ${offset} and ${length} more are past the file's end at ${size}`);
    const bytes = new Uint8Array(Number(length));
    let done = 0;
    while (done < bytes.length) {
      const place = Number(offset) + done;
      const { bytesRead } = await handle.read(bytes, done, bytes.length - done, place);
      if (bytesRead === 0) throw new Error("the file became shorter while it was read");
      done += bytesRead;
    }
    return bytes;
  }

  /** The bytes from `first` up to `end` in pieces. */
  async function* pieces(first, end) {
    const step = 1n << 20n;
    for (let offset = first; offset < end; offset += step)
      yield await read(offset, offset + step < end ? step : end - offset);
  }

  return { size: async () => size, read, pieces, close: () => handle.close() };
}
