// Parquet: the columns of numbers and of dates, under their names.
import { asyncBufferFromFile, parquetMetadataAsync, parquetReadObjects, parquetSchema } from "hyparquet";
import { compressors } from "hyparquet-compressors";

import { seconds } from "./messages.mjs";

const NUMBERS = ["INT32", "INT64", "FLOAT", "DOUBLE"];
const parsers = {
  timestampFromMilliseconds: (time) => seconds(time, 3),
  timestampFromMicroseconds: (time) => seconds(time, 6),
  timestampFromNanoseconds: (time) => seconds(time, 9),
};

function header({ name, logical_type, converted_type }) {
  const isTime = logical_type?.type === "TIMESTAMP" || /^TIMESTAMP/.test(converted_type);
  return name.replace(/[,"\n]/g, "_") + (isTime ? " [s]" : "");
}

const isDecimal = (element) => element.converted_type === "DECIMAL";

// A decimal has its own places, whatever a double makes of it.
function cell(value, element) {
  return (isDecimal(element) ? value?.toFixed(element.scale ?? 0) : value) ?? "";
}

async function* rowsOf(file, metadata, columns) {
  const names = columns.map(({ name }) => name);
  let rowStart = 0;
  for (const { num_rows } of metadata.row_groups) {
    const rowEnd = rowStart + Number(num_rows);
    const range = { file, metadata, columns: names, rowStart, rowEnd, compressors, parsers };
    for (const row of await parquetReadObjects(range)) {
      yield columns.map((column) => cell(row[column.name], column)).join(",");
    }
    rowStart = rowEnd;
  }
}

/** See import.mjs. */
export async function open(path) {
  const file = await asyncBufferFromFile(path);
  const metadata = await parquetMetadataAsync(file);
  const elements = parquetSchema(metadata).children.map(({ element }) => element);
  const columns = elements.filter(
    (element) => (NUMBERS.includes(element.type) || isDecimal(element)) && element.repetition_type !== "REPEATED",
  );
  const names = columns.map(({ name }) => name);
  const topic = { name: "all", type: names.join(" "), count: Number(metadata.num_rows), rate: true, temperature: true };
  const table = () => ({ header: columns.map(header), rows: rowsOf(file, metadata, columns) });
  return { topics: columns.length > 0 ? [topic] : [], table };
}
