// workbench_speed.mjs ENGINE.js RUN.csv: CPU time in Node, ms, of what one tick of the workbench's page does: `fit` of
// the model with the ticked effect, then `compare` of the run with it. Smallest of five; reading the run is not counted.
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";

const kRepeats = 5;
const kBase = "bias,bias_temperature:order=2,temperature_rate,temperature_rate_product";
const kTicks = {
  "a linear effect": "shupe:tau=900",
  "a ripple of fixed period": "polarization_ripple:period=13",
  "a lag that is searched": "thermal_lag",
  "a ripple whose period is searched": "polarization_ripple",
  "two shapes that are searched": "glass_transition",
};

const [engine_script, run] = process.argv.slice(2);
if (!run) {
  console.error("usage: workbench_speed.mjs ENGINE.js RUN.csv");
  process.exit(2);
}
const make_engine = createRequire(import.meta.url)(resolve(engine_script));
const engine = await make_engine({
  wasmBinary: readFileSync(engine_script.replace(/\.js$/, ".wasm")),
  progress: () => {},
  print: () => {},
  printErr: () => {},
});
engine.FS.writeFile("run.csv", readFileSync(run));

const call = (...words) => {
  const begun = process.cpuUsage();
  const found = JSON.parse(engine.ccall("fogcomp_call", "string", ["string"], [words.join("\n")]));
  const { user, system } = process.cpuUsage(begun);
  if (found.error) throw new Error(found.error);
  return (user + system) / 1000;
};

call("fit", "run.csv", "-o", "base.model", "--effects", kBase);
call("compare", "base.model", "run.csv");
for (const [name, effect] of Object.entries(kTicks)) {
  const fits = [];
  const compares = [];
  for (let i = 0; i < kRepeats; ++i) {
    fits.push(call("fit", "run.csv", "-o", "ticked.model", "--effects", `${kBase},${effect}`));
    compares.push(call("compare", "ticked.model", "run.csv"));
  }
  const [fit, compare] = [fits, compares].map((all) => Math.min(...all).toFixed(0));
  console.log(`${name}: fit ${fit} ms, compare ${compare} ms`);
}
