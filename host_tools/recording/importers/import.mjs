// import.mjs FORMAT FILE [TOPIC[,TEMPERATURE]]: prints a number of rows, then the table of FILE as CSV. FORMAT names the
// module that reads it. The last line on stderr says what was taken or, with exit code 2, what is wrong and what to do.
//
// Such a module exports open(path), which gives the file's topics and either a table of one or its messages:
//   topics    [{ name, type, count, rate, temperature }]; the last two are true if its messages have them
//   table(topic)   { header: [names], rows: an iterable of lines }
//   timeName, messages(names)   as gyroTable() takes them
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

import { gyroTable } from "./messages.mjs";
import { Refusal } from "./refusal.mjs";

const MAX_LISTED = 12;
const CHUNK_CHARACTERS = 1 << 16;

function listed(topics) {
  const shown = topics.slice(0, MAX_LISTED).map(({ name, type, count }) => `${name} (${type}, ${count})`);
  const more = topics.length > MAX_LISTED ? ` and ${topics.length - MAX_LISTED} more` : "";
  return shown.join(", ") + more || "nothing";
}

// The topic of that name, which must have `what` ("rate", "temperature").
function named(name, what, topics) {
  const topic = topics.find((each) => each.name === name);
  if (topic?.[what]) return topic;
  const able = listed(topics.filter((each) => each[what]));
  if (!topic) throw new Refusal(`has no topic '${name}'; those that have a ${what}: ${able}`);
  throw new Refusal(`'${name}' (${topic.type}) has no ${what}; those that have: ${able}`);
}

function chooseRate(name, topics) {
  if (name) return named(name, "rate", topics);
  const able = topics.filter(({ rate, count }) => rate && count > 0);
  if (able.length === 0) throw new Refusal(`no topic that is understood has a rate; it has ${listed(topics)}`);
  if (able.length > 1) {
    throw new Refusal(`the rate could be of ${listed(able)}; say which: --topic ${able[0].name}`);
  }
  return able[0];
}

// Undefined where there is none.
function chooseTemperature(name, rate, topics) {
  if (name) return named(name, "temperature", topics);
  if (rate.temperature) return rate;
  const able = topics.filter(({ temperature, count }) => temperature && count > 0);
  if (able.length > 1) {
    throw new Refusal(`the temperature could be of ${listed(able)}; say which: --topic ${rate.name},${able[0].name}`);
  }
  return able[0];
}

async function print(count, { header, rows }) {
  let text = `${count}\n${header.join(",")}\n`;
  for await (const row of rows) {
    text += row + "\n";
    if (text.length < CHUNK_CHARACTERS) continue;
    fs.writeFileSync(1, text);
    text = "";
  }
  fs.writeFileSync(1, text);
}

async function importFile(format, file, chosen) {
  const { open } = await import(`./${format}.mjs`);
  const log = await open(file);
  const [rateName, temperatureName] = chosen.split(",");
  const topic = chooseRate(rateName, log.topics);
  const temperature = chooseTemperature(temperatureName, topic, log.topics);
  await print(topic.count, log.table?.(topic) ?? gyroTable(log, topic, temperature));
  if (!temperature) console.error(`taken: ${listed([topic])}; there is no temperature`);
  else if (temperature === topic) console.error(`taken: ${listed([topic])}`);
  else console.error(`taken: ${listed([topic])}, temperature of ${listed([temperature])}`);
}

function complaint(error) {
  if (error instanceof Refusal) return error.message;
  if (error.code === "ERR_MODULE_NOT_FOUND") {
    const here = path.dirname(fileURLToPath(import.meta.url));
    let command = `npm ci --prefix '${here}'`;
    try {
      fs.accessSync(here, fs.constants.W_OK);
    } catch {
      command = `sudo ${command}`;
    }
    return `what reads it is not installed; install it: ${command}`;
  }
  return `cannot be read (${String(error.message ?? error).replace(/\s+/g, " ")}); is it complete?`;
}

const [format, file, chosen = ""] = process.argv.slice(2);
try {
  await importFile(format, file, chosen);
} catch (error) {
  if (error.code !== "EPIPE") console.error(complaint(error));
  process.exitCode = 2;
}
