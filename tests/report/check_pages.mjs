// node check_pages.mjs DRIVER FOLDER: compares the pages that in_browser.sh made in FOLDER with the --json of the
// same commands: names, order, and the figures of the bars.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { launch, new_page, open, show } from "./browser.mjs";

const [driver, folder] = process.argv.slice(2);
const json = (name) => JSON.parse(readFileSync(join(folder, name), "utf8"));
let failures = 0;
const check = (name, good, what) => {
  if (good) return;
  ++failures;
  console.error(`${name}: ${what}`);
};
const near = (a, b) => Math.abs(a - b) <= 1e-3 * Math.max(Math.abs(a), Math.abs(b)) + 1e-6; // four digits
const as_json = JSON.stringify;

// The texts of a page and the data of its plots.
const read = `(() => {
  const words = (element, selector) => [...element.querySelectorAll(selector)].map((one) => one.textContent);
  const drawn = JSON.parse(document.getElementById("plots").textContent);
  return {
    text: document.querySelector("main").textContent,
    found: document.querySelector("h1").textContent,
    headings: words(document, "h2"),
    bars: [...document.querySelectorAll("figure.bars")].map((figure) => ({
      caption: words(figure, "figcaption").join(),
      quantity: words(figure, ".quantity").join(),
      rows: [...figure.querySelectorAll(".row:not(.axis)")].map((row) => ({
        name: words(row, ".name").join(),
        values: words(row, ".value").map(Number),
        widths: [...row.querySelectorAll(".fill")].map((fill) => parseFloat(fill.style.width)),
      })),
    })),
    plots: drawn.map((plot, i) => ({ ...plot, title: document.querySelectorAll("figure.plot strong")[i].textContent })),
  };
})()`;

const browser = await launch(driver);
const page = async (name) => {
  const page = await new_page(browser);
  await show(page, { width: 1280, dark: false });
  await open(page, join(folder, name));
  return page.evaluate(read);
};
const bars_of = (seen, quantity, row) =>
  seen.bars.find((bars) => bars.quantity === quantity && bars.rows.some(({ name }) => name === row));

// Names of files are not typeset.
const names = async () => {
  for (const name of ["info.html", "fit.html", "compare.html", "diagnose.html", "add.html"]) {
    const seen = await page(name);
    check(name, seen.text.includes("run_degC.csv"), "does not name run_degC.csv");
    check(name, !as_json(seen).includes("run_°C"), "typesets the name of a file");
    check(name, seen.text.includes("°/h"), "does not typeset its own words");
  }
};

// Before and after are rms of what is left, by the model's mean alone and by the model.
const compare = async () => {
  const seen = await page("compare.html");
  json("compare.json").runs.forEach((run, i) => {
    const constant = run.raw_mean_dph - run.residual_mean_dph;
    const figures = bars_of({ bars: [seen.bars[i]] }, "rms left, °/h", "all");
    check("compare.html", figures, `run ${i} has no bars of rms left`);
    if (!figures) return;
    [...run.segments, { ...run, name: "all", mean_dph: run.residual_mean_dph, rms_dph: run.residual_rms_dph }].forEach(
      (segment) => {
        const row = figures.rows.find(({ name }) => name === segment.name);
        const before = Math.sqrt(
          segment.raw_std_dph ** 2 * (1 - 1 / segment.rows) + (segment.raw_mean_dph - constant) ** 2,
        );
        check(
          "compare.html",
          row && near(row.values[0], before) && near(row.values[1], segment.rms_dph),
          `${segment.name}: bars ${row && row.values} are not ${before} and ${segment.rms_dph}`,
        );
      },
    );
    const all = figures.rows.find(({ name }) => name === "all");
    check(
      "compare.html",
      all.values[1] < all.values[0] === run.residual_std_dph < run.raw_std_dph,
      "a model that helps looks as if it harmed",
    );
  });
};

// The ladder of a fit begins with what a constant alone leaves.
const fit = async () => {
  const { rows, quantity } = (await page("fit.html")).bars[0];
  const said = json("fit.json");
  check("fit.html", quantity === "rms left, °/h", `the ladder is of "${quantity}"`);
  check(
    "fit.html",
    near(rows[0].values[0], said.raw_std_dph) && near(rows[rows.length - 1].values[0], said.residual_rms_dph),
    `the ladder goes from ${rows[0].values} to ${rows[rows.length - 1].values}`,
  );
};

// Several models: the details are those of the best one, which is drawn last, on top; the curves are named.
const models = async () => {
  const name = "models.html";
  const seen = await page(name);
  check(name, seen.found.startsWith("rate.model is best"), `the sentence is "${seen.found}"`);
  check(name, /of the best, rate\.model/.test(seen.text), "does not say whose plots follow");
  const plot = (title) => seen.plots.find((one) => one.title === title);
  for (const title of ["Residual.", "Rate less input rate, the model on top.", "Autocorrelation of the residual."]) {
    const labels = plot(title).curves.map(({ label }) => label);
    check(
      name,
      labels[labels.length - 1] === "rate.model" && labels.includes("static.model"),
      `${title} draws ${labels.join(", ")}`,
    );
  }
  const allan = plot("Allan deviation in soaks.").curves.map(({ label }) => label);
  check(name, as_json(allan.slice(0, 3)) === as_json(["before", "static.model", "rate.model"]), `Allan: ${allan}`);
  const best = json("models.json").models.find(({ model }) => model === "rate.model").runs[0];
  const loop = seen.plots
    .find(({ title }) => title === "Residual over temperature.")
    .curves.find(({ label }) => label === "heating, mean");
  check(
    name,
    loop.y.every((y, i) => near(y, best.structure.history.heating_dph[i])),
    "the loop is of another model",
  );
  check(
    name,
    as_json(bars_of(seen, "rms left, °/h", "all").rows.map(({ values }) => values.length)).match(/^\[3(,3)*\]$/),
    "the bars do not have both models",
  );
};

// Bars of probability, the candidates in the JSON's order; the named effect is drawn over the residual.
const diagnose = async () => {
  const name = "diagnose.html";
  const seen = await page(name);
  const said = json("diagnose.json");
  const effects = seen.bars.filter(({ quantity }) => quantity.startsWith("probability"));
  check(name, effects.length === 2, `has ${effects.length} lists of probability, not sets and effects`);
  const [sets, candidates] = effects;
  check(
    name,
    as_json(candidates.rows.map((row) => row.name)) === as_json(said.candidates.map((one) => one.effect)),
    "the candidates have another order than the JSON",
  );
  said.candidates.forEach(({ effect, probability }, i) => {
    const { values, widths } = candidates.rows[i];
    check(
      name,
      Math.abs(values[0] - probability) < 6e-4 && Math.abs(widths[0] - 100 * probability) < 0.06,
      `${effect}: bar ${values[0]}, ${widths[0]} %, is not ${probability}`,
    );
  });
  check(name, /named/.test(candidates.caption), "the colours have no key");
  check(
    name,
    sets.rows[0].name === said.explanations[0].effects.join(" and "),
    "does not begin with the likeliest set",
  );
  const residual = seen.plots.find(({ title }) => title.startsWith("Residual, the model refitted"));
  check(
    name,
    residual.curves.some(({ label }) => label === `${said.effect ?? said.confusable[0]} would take out`),
    "does not draw what the named effect would take out",
  );
};

// The residual over every input that varies; the strongest dependence first.
const inputs = async () => {
  for (const name of ["input.html", "input_diagnose.html"]) {
    const seen = await page(name);
    const over = seen.plots.filter(({ title }) => /^Residual over /.test(title));
    const titles = over.map(({ title }) => title);
    check(
      name,
      titles[0] === "Residual over input rate." && titles.includes("Residual over light power."),
      `has ${titles.join(" ")}`,
    );
    check(
      name,
      over.every(({ curves }) => curves.some(({ label }) => /mean/.test(label))),
      "a plot has no means",
    );
    check(name, over[0].x_label === "input rate, °/h", `the axis is "${over[0].x_label}"`);
  }
};

const batch = async () => {
  const seen = await page("batch.html");
  const [plot] = seen.plots;
  check(
    "batch.html",
    as_json(plot.names.slice().sort()) === as_json(["G1", "SN0042", "loud"]),
    `the dots are ${plot.names}`,
  );
  check("batch.html", plot.kind === "log_x", "an outlier ruins the axis");
  check("batch.html", plot.x_label === "drift left, fit, °/h", `the axis is "${plot.x_label}"`);
};

const add = async () => {
  const seen = await page("add.html");
  const rows = seen.bars[0].rows;
  check("add.html", seen.bars[0].quantity === "rms left, °/h", "does not say what its bars are of");
  json("add.json").runs.forEach((run, i) => {
    check(
      "add.html",
      near(rows[i].values[0], run.rms_before_dph) && near(rows[i].values[1], run.rms_after_dph),
      `run ${i}: bars are ${rows[i].values}`,
    );
  });
};

try {
  for (const one of [names, fit, compare, models, diagnose, inputs, batch, add]) {
    await one().catch((error) => check(one.name, false, error.message));
  }
} finally {
  await browser.close();
}
process.exit(failures > 0 ? 1 : 0);
