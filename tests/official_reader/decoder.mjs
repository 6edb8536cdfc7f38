// SPDX-License-Identifier: Apache-2.0
import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";

/** A function that decodes one message of `channel` and insists that it takes every byte. */
export function makeDecoder(channel, schema) {
  const topic = channel.topic;
  if (schema === undefined) throw new Error(`${topic}: its schema ${channel.schemaId} is missing`);
  if (schema.encoding !== "ros2msg" || channel.messageEncoding !== "cdr")
    throw new Error(`${topic}: ${schema.encoding} in ${channel.messageEncoding} is not ros2msg in cdr`);
  const text = new TextDecoder("utf-8", { fatal: true }).decode(schema.data);
  const reader = new MessageReader(parse(text, { ros2: true }));
  return (message) => {
    try {
      const decoded = reader.readMessage(message.data);
      if (reader.lastReadHadTrailingBytes())
        throw new Error(`${reader.lastReadByteLength()} of ${message.data.length} bytes are used`);
      return decoded;
    } catch (error) {
      throw new Error(`${topic}: message ${message.sequence} is not as its schema says: ${error.message}`);
    }
  };
}
