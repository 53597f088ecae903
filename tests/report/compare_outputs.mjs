// node compare_outputs.mjs PAGE SHELL...: compares pairs of files word by word. Numbers may differ by `tolerance`,
// because the page's C library and the host's round the last bit of exp and sin differently; hashes may differ. A
// chance is the exponential of what is computed, so that 1e-127 has 300 times its relative error: logarithms are
// compared.
import { readFileSync } from "node:fs";

const tolerance = 1e-6; // relative; below every uncertainty of a coefficient
const hash = /\b(crc|hash)\b/i; // here, or in the comment above
const chance = /"chance": /;
const names = process.argv.slice(2);
const lines_of = (name) => readFileSync(name, "utf8").trim().split("\n");
const compare = (page_name, shell_name) => {
  const page = lines_of(page_name);
  const shell = lines_of(shell_name);
  let largest = 0;
  const differ = (what) => {
    console.error(`the page's ${page_name} is not the shell's: ${what}`);
    process.exit(1);
  };
  if (page.length !== shell.length) differ(`${page.length} lines, ${shell.length} lines`);
  page.forEach((line, i) => {
    if (line === shell[i] || hash.test(line) || (i > 0 && hash.test(page[i - 1]))) return;
    const words = [line, shell[i]].map((text) => text.split(/[ ,<>]/));
    if (words[0].length !== words[1].length) differ(`${line} | ${shell[i]}`);
    words[0].forEach((word, w) => {
      const other = words[1][w];
      if (word === other) return;
      const small = chance.test(line) && word < 0.5;
      const [a, b] = small ? [Math.log(word), Math.log(other)] : [Number(word), Number(other)];
      const off = Math.abs(a - b) / Math.max(Math.abs(a), Math.abs(b));
      if (!(off <= tolerance)) differ(`${line} | ${shell[i]}`);
      largest = Math.max(largest, off);
    });
  });
  console.log(
    `${page_name}: ${largest === 0 ? "the same bytes" : `differs by at most ${largest.toExponential(1)} of a figure`}`,
  );
};
for (let i = 0; i < names.length; i += 2) compare(names[i], names[i + 1]);
