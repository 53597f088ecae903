// ULog of PX4; https://docs.px4.io/main/en/dev_log/ulog_file_format.html. Its times are those since the start.
import { ULog } from "@foxglove/ulog";
import { FileReader } from "@foxglove/ulog/node.js";

import { seconds } from "./messages.mjs";

// What the messages of PX4 have of a gyro. vehicle_angular_velocity is left out: it is filtered, less estimated biases.
const MEANINGS = {
  sensor_gyro: { rate: ({ x, y, z }) => [x, y, z], temperature: ({ temperature }) => temperature },
  sensor_combined: { rate: ({ gyro_rad }) => gyro_rad },
};

function topicsOf(ulog) {
  const subscriptions = [...ulog.subscriptions];
  return subscriptions.map(([id, { name: type, multiId }]) => {
    const several = subscriptions.filter(([, { name }]) => name === type).length > 1;
    const name = several ? `${type}:${multiId}` : type;
    return { id, name, type, count: ulog.dataMessageCounts().get(id) ?? 0, ...MEANINGS[type] };
  });
}

/** See import.mjs. */
export async function open(path) {
  const ulog = new ULog(new FileReader(path));
  await ulog.open();
  const topics = topicsOf(ulog);
  return {
    topics,
    timeName: "time_s",
    async *messages(names) {
      const chosen = new Map(topics.filter(({ name }) => names.includes(name)).map(({ id, name }) => [id, name]));
      for await (const { msgId, value } of ulog.readMessages({ msgIds: new Set(chosen.keys()), includeLogs: false })) {
        const microseconds = value.timestamp_sample || value.timestamp;
        yield { topic: chosen.get(msgId), time: seconds(microseconds, 6), message: value };
      }
    },
  };
}
