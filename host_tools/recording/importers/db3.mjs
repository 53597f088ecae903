// Bags of ROS 2 in SQLite (rosbag2_storage_sqlite3).
import fs from "node:fs";

import rosmsg from "@foxglove/rosmsg";
import { ros2humble } from "@foxglove/rosmsg-msgs-common";
import ros2 from "@foxglove/rosmsg2-serialization";
import initSqlJs from "sql.js";

import { Refusal } from "./refusal.mjs";
import { ifUnderstood, meaning, timeOf } from "./ros.mjs";

function* rowsOf(database, query, parameters = []) {
  const statement = database.prepare(query, parameters);
  while (statement.step()) yield statement.get(null, { useBigInt: true });
  statement.free();
}

// Definitions by the name of their type. Bags of Iron and later hold them; of older ones the common types are known.
function definitionTexts(database, hasTable) {
  const definitions = new Map();
  if (!hasTable("message_definitions")) return definitions;
  const query = "SELECT topic_type, encoded_message_definition FROM message_definitions WHERE encoding = 'ros2msg'";
  for (const [type, text] of rowsOf(database, query)) definitions.set(type, text);
  return definitions;
}

function commonDefinitions(type) {
  const name = type.replace("/msg/", "/");
  if (!(name in ros2humble)) return undefined;
  const root = ros2humble[name];
  return [root, ...Object.values(ros2humble).filter((each) => each !== root)];
}

const MAX_BYTES = 1 << 30; // sql.js holds all of it in memory

// How messages of a type are decoded and what they have; undefined for a type that is not known.
function decoder(type, format, texts) {
  const text = texts.get(type);
  const definitions = text === undefined ? commonDefinitions(type) : rosmsg.parse(text, { ros2: true });
  if (format !== "cdr" || definitions === undefined) return undefined;
  return { reader: new ros2.MessageReader(definitions), ...meaning(definitions) };
}

async function openDatabase(path) {
  if (fs.statSync(path).size > MAX_BYTES) {
    throw new Refusal("is larger than 1 GiB; make an MCAP file of it: ros2 bag convert");
  }
  const SQL = await initSqlJs();
  const database = new SQL.Database(fs.readFileSync(path));
  const tables = new Set([...rowsOf(database, "SELECT name FROM sqlite_master WHERE type = 'table'")].flat());
  if (!tables.has("topics") || !tables.has("messages")) {
    throw new Refusal(
      `is a database of ${[...tables].join(", ") || "no tables"}, not a ROS 2 bag; write a CSV with sqlite3`,
    );
  }
  return { database, definitions: definitionTexts(database, (name) => tables.has(name)) };
}

/** See import.mjs. */
export async function open(path) {
  const { database, definitions } = await openDatabase(path);
  const readers = new Map();
  const topics = new Map();
  const query =
    "SELECT id, name, type, serialization_format, (SELECT count(*) FROM messages WHERE topic_id = topics.id) FROM topics";
  for (const [id, name, type, format, count] of rowsOf(database, query)) {
    const { reader, ...has } = ifUnderstood(() => decoder(type, format, definitions)) ?? {};
    if (reader) readers.set(id, { name, reader });
    const all = (topics.get(name)?.count ?? 0) + Number(count);
    topics.set(name, { name, type, count: all, ...has });
  }
  return {
    topics: [...topics.values()],
    timeName: "time [s]",
    *messages(names) {
      const ids = [...readers.keys()].filter((id) => names.includes(readers.get(id).name));
      const chosen = `SELECT topic_id, timestamp, data FROM messages WHERE topic_id IN (${ids}) ORDER BY timestamp, id`;
      for (const [id, logged, data] of rowsOf(database, chosen)) {
        const { name, reader } = readers.get(id);
        const message = reader.readMessage(data);
        yield { topic: name, time: timeOf(message, logged), message };
      }
    },
  };
}
