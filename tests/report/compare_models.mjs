// node compare_models.mjs PAGE SHELL: two model files word by word. Numbers may differ in what the C libraries' functions
// differ in: the page's and the host's round the last bit of exp and sin unlike.
import { readFileSync } from "node:fs";

const tolerance = 1e-6; // relative; below every uncertainty of a coefficient
const [page, shell] = process.argv.slice(2).map((name) => readFileSync(name, "utf8").trim().split("\n"));
let largest = 0;
const differ = (what) => {
  console.error(`the page's model is not the shell's: ${what}`);
  process.exit(1);
};
if (page.length !== shell.length) differ(`${page.length} lines, ${shell.length} lines`);
page.forEach((line, i) => {
  if (line.startsWith("crc ")) return;
  const words = [line, shell[i]].map((text) => text.split(" "));
  if (words[0].length !== words[1].length) differ(`${line} | ${shell[i]}`);
  words[0].forEach((word, w) => {
    const other = words[1][w];
    if (word === other) return;
    const off = Math.abs(word - other) / Math.max(Math.abs(word), Math.abs(other));
    if (!(off <= tolerance)) differ(`${line} | ${shell[i]}`);
    largest = Math.max(largest, off);
  });
});
console.log(`the session's model and the shell's differ by at most ${largest.toExponential(1)} of a figure`);
