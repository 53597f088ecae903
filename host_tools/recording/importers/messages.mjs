// Tables of logs that hold messages of several topics, one after the other.

/** Whole nanoseconds as decimal seconds, every digit kept. */
export function seconds(nanoseconds, digits = 9) {
  const text = String(nanoseconds).padStart(digits + 1, "0");
  return `${text.slice(0, -digits)}.${text.slice(-digits)}`;
}

/**
 * The table of a gyro: a line for each message of `topic`, with the latest temperature before it; none yet is an empty
 * field. `log`: timeName, messages(names), which iterates over { topic, time (text), message } in the order of the
 * log. Topics: rate(message) gives [x, y, z] in rad/s, temperature(message) a number in degC.
 */
export function gyroTable(log, topic, temperature) {
  const axes = ["rate_x [rad/s]", "rate_y [rad/s]", "rate_z [rad/s]"];
  const header = [log.timeName, ...(temperature ? ["temperature_degc"] : []), ...axes];
  return { header, rows: gyroRows(log, topic, temperature) };
}

async function* gyroRows(log, topic, temperature) {
  const names = [...new Set([topic.name, (temperature ?? topic).name])];
  let latest = "";
  for await (const { topic: name, time, message } of log.messages(names)) {
    if (name === temperature?.name) latest = temperature.temperature(message);
    if (name !== topic.name) continue;
    const [x, y, z] = topic.rate(message);
    yield temperature ? `${time},${latest},${x},${y},${z}` : `${time},${x},${y},${z}`;
  }
}
