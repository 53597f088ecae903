// HDF5, and MAT 7.3, which is HDF5. A topic is a table: the columns of one length in a group, or a compound dataset.
import h5wasm from "h5wasm/node";

import { Refusal } from "./refusal.mjs";

const ROWS_AT_ONCE = 1 << 16;
const MAX_COLUMNS = 64; // of a matrix
const INTEGER = 0;
const FLOAT = 1;
const COMPOUND = 6;
// deflate, shuffle, fletcher32, szip, nbit, scaleoffset. Of others h5wasm gives numbers that are not in the file.
const KNOWN_FILTERS = [1, 2, 3, 4, 5, 6];

// Numbers of 16 bits are integers: h5wasm has no such floats.
const isNumber = ({ type, size }) => type === INTEGER || (type === FLOAT && size >= 4);

function nameOf(dataset, leaf) {
  const attributes = dataset.attrs;
  const unit = (attributes.units ?? attributes.unit)?.value;
  const name = leaf.replace(/[\s,"]/g, "_");
  return unit ? `${name} [${unit}]` : name;
}

function requireKnownFilters(dataset) {
  const unknown = dataset.filters.find(({ id }) => !KNOWN_FILTERS.includes(id));
  if (!unknown) return;
  throw new Refusal(
    `${dataset.path} is compressed by filter ${unknown.id} (${unknown.name}); write it with gzip instead`,
  );
}

// The columns of a dataset: { name, rows, read(from, to) }; none if it holds no numbers in rows.
function columnsOf(dataset, leaf) {
  const { shape, metadata } = dataset;
  const isText = dataset.attrs.MATLAB_class?.value === "char";
  if (!shape || shape.length < 1 || shape.length > 2 || !isNumber(metadata) || isText) return [];
  const along = shape.length === 2 && shape[1] > shape[0] ? 1 : 0;
  const count = shape.length === 2 ? shape[1 - along] : 1;
  if (count > MAX_COLUMNS) return [];
  const name = nameOf(dataset, leaf);
  return Array.from({ length: count }, (_, column) => ({
    name: count === 1 ? name : name.replace(/( \[|$)/, `_${column + 1}$1`),
    rows: shape[along],
    dataset,
    read(from, to) {
      const ranges = [[from, to]];
      if (shape.length === 2) ranges.splice(1 - along, 0, [column, column + 1]);
      return dataset.slice(ranges);
    },
  }));
}

// The members of a compound dataset, as columns.
function membersOf(dataset) {
  const { shape, metadata } = dataset;
  if (shape?.length !== 1 || metadata.type !== COMPOUND) return [];
  const members = metadata.compound_type.members.map((member, index) => ({ ...member, index }));
  return members.filter(isNumber).map(({ name, index }) => ({
    name: name.replace(/[\s,"]/g, "_"),
    rows: shape[0],
    dataset,
    read: (from, to) => dataset.slice([[from, to]]).map((row) => row[index]),
  }));
}

function topicOf(name, columns) {
  const type = columns.map((column) => column.name).join(" ");
  return { name, type, count: columns[0].rows, columns, rate: true, temperature: true };
}

// Of a group's columns those of one length, of which there are most.
function longestTable(columns) {
  const byLength = new Map();
  for (const column of columns) byLength.set(column.rows, [...(byLength.get(column.rows) ?? []), column]);
  return [...byLength.values()].sort((a, b) => b.length - a.length || b[0].rows - a[0].rows)[0] ?? [];
}

function collect(group, path, topics) {
  const columns = [];
  for (const leaf of group.keys()) {
    // MATLAB's own groups; soft links, which may lead nowhere or back.
    if (leaf.startsWith("#") || group.get_link(`${path}/${leaf}`) !== null) continue;
    const child = group.get(leaf);
    if (child?.type === "Group") collect(child, `${path}/${leaf}`, topics);
    if (child?.type !== "Dataset") continue;
    columns.push(...columnsOf(child, leaf));
    const members = membersOf(child);
    if (members.length > 1) topics.push(topicOf(`${path}/${leaf}`, members));
  }
  const table = longestTable(columns);
  if (table.length > 1) topics.push(topicOf(path || "/", table));
}

function* rowsOf({ columns, count }) {
  for (const { dataset } of columns) requireKnownFilters(dataset);
  for (let from = 0; from < count; from += ROWS_AT_ONCE) {
    const to = Math.min(from + ROWS_AT_ONCE, count);
    const values = columns.map((column) => column.read(from, to));
    for (let row = 0; row < to - from; ++row) yield values.map((column) => column[row]).join(",");
  }
}

/** See import.mjs. */
export async function open(path) {
  await h5wasm.ready;
  const file = new h5wasm.File(path, "r");
  if (file.file_id < 0n) throw new Refusal("cannot be opened by HDF5; is it complete?");
  const topics = [];
  collect(file, "", topics);
  return { topics, table: (topic) => ({ header: topic.columns.map(({ name }) => name), rows: rowsOf(topic) }) };
}
