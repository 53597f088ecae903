// MCAP with messages of ROS 1 or 2; https://mcap.dev/spec
import fs from "node:fs/promises";

import lz4 from "@foxglove/wasm-lz4";
import zstd from "@foxglove/wasm-zstd";
import rosmsg from "@foxglove/rosmsg";
import ros1 from "@foxglove/rosmsg-serialization";
import ros2 from "@foxglove/rosmsg2-serialization";
import { McapIndexedReader } from "@mcap/core";

import { Refusal } from "./refusal.mjs";
import { ifUnderstood, meaning, timeOf } from "./ros.mjs";

class ReadableFile {
  constructor(handle, bytes) {
    this.handle = handle;
    this.bytes = bytes;
  }
  async size() {
    return this.bytes;
  }
  async read(offset, length) {
    const place = new Uint8Array(Number(length));
    const { bytesRead } = await this.handle.read(place, 0, place.length, Number(offset));
    return place.subarray(0, bytesRead);
  }
}

async function indexedReader(path) {
  await Promise.all([lz4.isLoaded, zstd.isLoaded]);
  const handle = await fs.open(path);
  const { size } = await handle.stat({ bigint: true });
  const decompressHandlers = {
    lz4: (bytes, size) => lz4(bytes, Number(size)),
    zstd: (bytes, size) => zstd.decompress(bytes, Number(size)),
  };
  try {
    return await McapIndexedReader.Initialize({ readable: new ReadableFile(handle, size), decompressHandlers });
  } catch (error) {
    await handle.close();
    throw new Refusal(
      `has no index (${error.message}); if its recorder was cut off: mcap recover ${path} -o whole.mcap`,
    );
  }
}

// How the messages of a channel are decoded and what they have; undefined for what is not of ROS.
function decoder(channel, schema) {
  const text = new TextDecoder().decode(schema?.data);
  if (channel.messageEncoding === "ros1" && schema?.encoding === "ros1msg") {
    const definitions = rosmsg.parse(text);
    return { reader: new ros1.MessageReader(definitions), ...meaning(definitions) };
  }
  if (channel.messageEncoding === "cdr" && schema?.encoding === "ros2msg") {
    const definitions = rosmsg.parse(text, { ros2: true });
    return { reader: new ros2.MessageReader(definitions), ...meaning(definitions) };
  }
  return undefined;
}

/** See import.mjs. */
export async function open(path) {
  const reader = await indexedReader(path);
  const topics = new Map();
  const readers = new Map();
  for (const channel of reader.channelsById.values()) {
    const schema = reader.schemasById.get(channel.schemaId);
    const { reader: messageReader, ...has } = ifUnderstood(() => decoder(channel, schema)) ?? {};
    const count = Number(reader.statistics?.channelMessageCounts.get(channel.id) ?? 0);
    const before = topics.get(channel.topic)?.count ?? 0;
    const type = schema?.name ?? channel.messageEncoding;
    topics.set(channel.topic, {
      name: channel.topic,
      type: messageReader ? type : `${type} as ${channel.messageEncoding}`,
      count: before + count,
      ...has,
    });
    if (messageReader) readers.set(channel.id, messageReader);
  }
  return {
    topics: [...topics.values()],
    timeName: "time [s]",
    async *messages(names) {
      for await (const { channelId, logTime, data } of reader.readMessages({ topics: names })) {
        const message = readers.get(channelId).readMessage(data);
        yield { topic: reader.channelsById.get(channelId).topic, time: timeOf(message, logTime), message };
      }
    },
  };
}
