// Undo and redo: each state is a model and the command that made it. Undone states stay until the next
// change.
"use strict";
const base_name = (path) => path.split("/").pop();
const setup = JSON.parse(text_of("setup"));

const shell_word = (word) => (/^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);
const shell_line = (words) => ["fogcomp", ...words].map(shell_word).join(" ");

class States {
  list = [];
  at = -1;
  #models = 0;

  get now() {
    return this.list[this.at];
  }
  get path() {
    return this.list.slice(0, this.at + 1);
  }
  // A file name that no model of the page has had.
  next_model() {
    ++this.#models;
    const name = `m${this.#models}.model`;
    return setup.states.some(({ model }) => model === name) ? this.next_model() : name;
  }
  reserve(name) {
    this.#models = Math.max(this.#models, Number((name.match(/^m(\d+)\.model$/) || [0, 0])[1]));
  }
  push(state) {
    this.list.splice(this.at + 1);
    this.list.push(state);
    this.at = this.list.length - 1;
  }
  go(index) {
    if (index >= 0 && index < this.list.length) this.at = index;
  }

  // The commands that make the current model, from the last `fit` on.
  commands() {
    const begin = this.path.map((state) => state.words && state.words[0] === "fit").lastIndexOf(true);
    return this.path
      .slice(Math.max(begin, 0))
      .filter((state) => state.words)
      .map((state) => state.words);
  }
}

const states = new States();

// Masks are [run, from, to] in seconds since power-on.
const mask_words = (masks) =>
  masks.flatMap(([run, from, to]) => [
    "--mask",
    (setup.runs.length + setup.holdouts.length > 1 ? run + ":" : "") + `${from}..${to}`,
  ]);
const masks_from = (words) =>
  words.flatMap((word, i) => {
    if (words[i - 1] !== "--mask") return [];
    const [, run, from, to] = word.match(/^(?:(.*):)?([^:]*)\.\.([^:]*)$/);
    return (run ? [run] : [...setup.runs, ...setup.holdouts]).map((name) => [name, Number(from), Number(to)]);
  });
const masks_on = (masks, verb) => (verb === "fit" ? masks.filter(([run]) => setup.runs.includes(run)) : masks);

// The command lines: recordings, holdouts, options for reading them, masks.
const judged_by = () => setup.holdouts.flatMap((name) => ["--holdout", name]);
// `rows`: the current model's options of the fit's rows (rows_of).
const fit_words = (effects, expressions, model, masks, rows = []) => [
  "fit",
  ...setup.runs,
  ...setup.reading,
  ...mask_words(masks_on(masks, "fit")),
  "--effects",
  effects.join(","),
  ...expressions.flatMap((one) => ["--effect-expr", one]),
  ...rows,
  "-o",
  model,
];
const rows_of = (view) => [
  ...(view.average_s === 10 ? [] : ["--average", String(view.average_s)]),
  ...(view.derivative_tau_s === 30 ? [] : ["--derivative-tau", String(view.derivative_tau_s)]),
];
const add_words = (from, what, model, masks, verb = "add") => [
  verb,
  from,
  ...(what.expression ? [] : what.effects),
  ...setup.runs,
  ...judged_by(),
  ...setup.reading,
  ...mask_words(masks),
  ...(what.expression ? ["--effect-expr", what.expression] : []),
  ...(what.run_offsets ? ["--run-offsets"] : []),
  "-o",
  model,
];
const compare_words = (model, masks) => [
  "compare",
  model,
  ...setup.runs,
  ...setup.holdouts,
  ...setup.reading,
  ...mask_words(masks),
];
const diagnose_words = (model, masks) => [
  "diagnose",
  model,
  ...setup.runs,
  ...judged_by(),
  ...setup.reading,
  ...mask_words(masks),
];

const words_of_terms = (view) => view.terms.map((term) => term.words);
// Sentences about the bias steps that were found.
const steps_of = (view) => view.terms.map((term) => term.step).filter(Boolean);
const effects_of = (view) =>
  view.terms
    .filter((term) => !term.is_expression)
    .map((term) => term.words)
    .filter((words, i, all) => all.indexOf(words) === i);
const expressions_of = (view) => view.terms.filter((term) => term.is_expression).map((term) => term.words);
const effect_name = (words) => words.split(":")[0];

// The words of an effect with a shape parameter fixed, or to be identified ("?").
const with_parameter = (words, parameter, value) => {
  const [name, ...given] = words.split(":");
  const others = given.filter((one) => !one.startsWith(parameter + "="));
  return [name, ...others, `${parameter}=${value}`].join(":");
};
