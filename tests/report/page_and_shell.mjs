// node page_and_shell.mjs FOGCOMP PAGE: runs the same commands in the page's engine and in FOGCOMP, in this folder, and
// compares every figure and word of their answers and files.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { runInThisContext } from "node:vm";
import { gunzipSync } from "node:zlib";

const [fogcomp, page_file] = process.argv.slice(2);
// Relative. A shape is where a sum of squares is least, and flat: what rounds the last bit of exp and sin otherwise moves
// it by the root of that.
const tolerance = Math.sqrt(Number.EPSILON);
const rounding = 1e-12; // of the largest figure of an answer: what is 0 but for rounding

// The page's worker, as a browser runs it.
const page = readFileSync(page_file, "utf8");
const part = (id) => page.match(new RegExp(`<script type="text/plain" id="${id}">([^]*?)</script>`))[1];
globalThis.require = createRequire(import.meta.url);
globalThis.__dirname = ".";
const waiting = [];
globalThis.postMessage = (data) => data.id !== undefined && waiting.shift()(data);
runInThisContext(part("engine_script"));
const send = (data) =>
  new Promise((done) => {
    waiting.push(done);
    globalThis.onmessage({ data: { id: 0, columns: [], files: [], ...data } });
  });

const in_page = async (words, files = []) => {
  const { found, fault } = await send({ words, files });
  if (fault) throw new Error(`${words.join(" ")}: ${fault}`);
  return found;
};
// The JSON of a command that has one, or its refusal.
const in_shell = (words) => {
  const json = ["fit", "add", "compare", "diagnose", "info"].includes(words[0]);
  try {
    const options = { maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "pipe"] };
    const said = execFileSync(fogcomp, [...words, ...(json ? ["--json"] : [])], options);
    return json ? JSON.parse(said) : {};
  } catch ({ status, stderr }) {
    return { error: status === 2 ? String(stderr).trim().split("\n").pop() : `exit code ${status}` };
  }
};

// The largest relative difference of two answers, and where it is; throws where a word differs.
const largest_of = (one) => {
  if (typeof one === "number") return Math.abs(one);
  return one && typeof one === "object" ? Math.max(0, ...Object.values(one).map(largest_of)) : 0;
};
const difference = (a, b, path, floor) => {
  const at_path = (off) => ({ off, where: `${path}: ${a} | ${b}` });
  if (a === b) return at_path(0);
  if (typeof a === "number" && typeof b === "number") {
    // A chance is the exponential of what is computed: 1e-127 has 300 times its relative error.
    const logarithmic = /chance|probability|lead|nothing_missing|something_else/.test(path) && a > 0 && b > 0;
    if (logarithmic) return at_path(Math.abs(Math.log(a) - Math.log(b)) / Math.max(1, Math.abs(Math.log(a))));
    const off = Math.abs(a - b);
    return at_path(off <= floor ? 0 : off / Math.max(Math.abs(a), Math.abs(b)));
  }
  if (!a || !b || typeof a !== "object" || typeof b !== "object") throw new Error(`${path}: ${a} | ${b}`);
  const names = new Set([...Object.keys(a), ...Object.keys(b)]);
  const each = [...names].map((name) => difference(a[name], b[name], `${path}.${name}`, floor));
  return each.reduce((most, one) => (one.off > most.off ? one : most), at_path(0));
};

// A text as words and numbers; hashes differ with the last bit.
const parsed = (text) =>
  text
    .split("\n")
    .filter((line, i, all) => !/\b(crc|hash)\b/i.test(line + (all[i - 1] || "")))
    .map((line) => line.split(/[ ,<>=:;"(){}]+/).map((word) => (word !== "" && isFinite(word) ? Number(word) : word)));

let compared = 0;
let failures = 0;
let largest = 0;
const compare = (what, page_has, shell_has) => {
  ++compared;
  try {
    const { off, where } = difference(page_has, shell_has, "", rounding * largest_of(shell_has));
    largest = Math.max(largest, off);
    if (off <= tolerance) return;
    console.error(`${what}: differs by ${off.toExponential(1)} of a figure at ${where}`);
  } catch (fault) {
    console.error(`${what}: differs at ${fault.message}`);
  }
  ++failures;
};

const part_of = { fit: "fit", add: "add", compare: "compare", diagnose: "diagnosis" };
const output_of = { fit: "-o", add: "-o", export: "-o", apply: "-o", history: "--report" };
const answer = async (words) => {
  const { remarks, ...found } = await in_page(words);
  const shell_has = in_shell(words);
  const line = words.join(" ");
  if (found.error || shell_has.error) {
    compare(line, found.error, shell_has.error);
    return;
  }
  if (words[0] === "info") compare(line, found, shell_has);
  if (part_of[words[0]]) compare(line, found[part_of[words[0]]], shell_has);
  const option = output_of[words[0]];
  if (!option || found.text === undefined) return;
  const file = readFileSync(words[words.indexOf(option) + 1], "utf8");
  compare(`${line}: its file`, parsed(found.text), parsed(file));
};

const drift = "bias,bias_temperature:order=2,temperature_rate";
const [one, two, three, table, mems] = ["run.csv", "other.csv", "third.csv", "table.csv", "mems.csv"];
const cubic = "bias,bias_temperature:order=3";
// Effects of a fit, and one that is added to it.
const sets = [
  { runs: [one], effects: "bias,bias_temperature", more: "temperature_rate" },
  { runs: [one], masks: ["3000..5000"], effects: "bias,bias_temperature", more: "thermal_hysteresis" },
  { runs: [one], holdouts: [two], effects: "bias", more: "bias_temperature" },
  { runs: [one, two], effects: "bias,bias_temperature", more: "thermal_lag" },
  { runs: [one, two], masks: ["other.csv:100..900"], effects: drift, more: "polarization_ripple" },
  { runs: [one, two, three], effects: "bias", more: "bias_temperature" },
  { runs: [one, two, three], effects: drift, more: "warm_up" },
  { runs: [one, three], holdouts: [two], effects: drift, more: "temperature_rate_product" },
  { runs: [table], effects: cubic, more: "scale_factor" },
  { runs: [table], masks: ["9000..9600"], effects: "bias,scale_factor", more: "bias_temperature" },
  { runs: [mems], effects: cubic, more: "thermal_lag" },
  { runs: [mems], masks: ["1000..1100"], effects: cubic, more: "temperature_rate" },
];
const replay = async ({ runs, holdouts = [], masks = [], effects, more }, s) => {
  const masked = masks.flatMap((range) => ["--mask", range]);
  const judged = holdouts.flatMap((file) => ["--holdout", file]);
  const [model, grown] = [`set${s}.model`, `set${s}_grown.model`];
  await answer(["fit", ...runs, ...masked, "--effects", effects, "-o", model]);
  await answer(["compare", model, ...runs, ...holdouts, ...masked]);
  await answer(["diagnose", model, ...runs, ...judged, ...masked]);
  await answer(["add", model, more, ...runs, ...judged, ...masked, "--force", "-o", grown]);
  await answer(["compare", grown, ...runs, ...holdouts, ...masked]);
  await answer(["export", grown, "-o", "made.h"]);
  await answer(["apply", grown, runs[0], "-o", "made.csv"]);
  await answer(["history", grown, "--report", "made.html"]);
};

try {
  await send({ module: await WebAssembly.compile(gunzipSync(Buffer.from(part("engine"), "base64"))) });
  for (const name of [one, two, three, table, mems]) {
    await in_page(["effects"], [{ name, bytes: readFileSync(name) }]);
    await answer(["info", name]);
  }
  for (const [s, set] of sets.entries()) await replay(set, s);
} catch (fault) {
  console.error(fault.message); // uncaught, the engine's script would come with it
  ++failures;
}
console.log(
  `${compared} comparisons, ${failures} differ by more than ${tolerance.toExponential(1)}; the largest by ${largest.toExponential(1)}`,
);
process.exit(failures > 0 || compared < 120 ? 1 : 0);
