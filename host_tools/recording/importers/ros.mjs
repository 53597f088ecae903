// Messages of ROS 1 and 2: what a type says, and when a message was sampled.
import { seconds } from "./messages.mjs";

/** What `read` gives; undefined for a type that is not understood: it may be of a topic that nobody wants. */
export function ifUnderstood(read) {
  try {
    return read();
  } catch {
    return undefined;
  }
}

/** The members of a topic that say what its messages have; `definitions` as parsed, the topic's own type first. */
export function meaning(definitions) {
  const root = definitions.find(({ name }) => name === undefined) ?? definitions[0];
  const fields = root.definitions.filter(({ isConstant }) => !isConstant);
  const field = (name) => fields.find((each) => each.name === name && !each.isArray);
  const found = {};
  if (/(^|\/)Vector3$/.test(field("angular_velocity")?.type)) {
    found.rate = ({ angular_velocity: { x, y, z } }) => [x, y, z];
  }
  if (/^(float|u?int)\d+$/.test(field("temperature")?.type)) found.temperature = ({ temperature }) => temperature;
  return found;
}

/** The time of a message as text: its own stamp or, if the sender left that 0, that of the log (in ns). */
export function timeOf(message, logged) {
  const { sec = 0, nsec = 0, nanosec = nsec } = message.header?.stamp ?? {};
  if (sec === 0 && nanosec === 0) return seconds(logged);
  return `${sec}.${String(nanosec).padStart(9, "0")}`;
}
