// ROS bags, format 2.0; http://wiki.ros.org/Bags/Format/2.0
import { Bag } from "@foxglove/rosbag";
import { FileReader } from "@foxglove/rosbag/node.js";
import { parse } from "@foxglove/rosmsg";
import Bzip2 from "@foxglove/wasm-bz2";
import lz4 from "@foxglove/wasm-lz4";

import { Refusal } from "./refusal.mjs";
import { ifUnderstood, meaning, timeOf } from "./ros.mjs";

async function openBag(path) {
  await lz4.isLoaded;
  const bzip2 = await Bzip2.init();
  const decompress = {
    lz4: (bytes, size) => lz4(bytes, size),
    bz2: (bytes, size) => bzip2.decompress(bytes, size, { small: false }),
  };
  const bag = new Bag(new FileReader(path), { decompress });
  await bag.open();
  if (bag.chunkInfos.length === 0) {
    throw new Refusal(`has no index, its recorder was cut off; repair it: rosbag reindex ${path}`);
  }
  return bag;
}

function topicsOf(bag) {
  const counts = new Map();
  for (const { connections } of bag.chunkInfos) {
    for (const { conn, count } of connections) counts.set(conn, (counts.get(conn) ?? 0) + count);
  }
  const topics = new Map();
  for (const [id, { topic: name, type, messageDefinition }] of bag.connections) {
    const count = (topics.get(name)?.count ?? 0) + (counts.get(id) ?? 0);
    topics.set(name, { name, type, count, ...ifUnderstood(() => meaning(parse(messageDefinition))) });
  }
  return [...topics.values()];
}

/** See import.mjs. */
export async function open(path) {
  const bag = await openBag(path);
  return {
    topics: topicsOf(bag),
    timeName: "time [s]",
    async *messages(topics) {
      for await (const { topic, timestamp, message } of bag.messageIterator({ topics })) {
        const logged = BigInt(timestamp.sec) * 1_000_000_000n + BigInt(timestamp.nsec);
        yield { topic, time: timeOf(message, logged), message };
      }
    },
  };
}
