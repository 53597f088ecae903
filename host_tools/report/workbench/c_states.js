// Undo and redo: each state is a model and the command that made it. Undone states stay until the next
// change.
"use strict";
const base_name = (path) => path.split("/").pop();
const setup = JSON.parse(text_of("setup"));

const shell_word = (word) => (/^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);
const shell_line = (words) => ["fogcomp", ...words].map(shell_word).join(" ");

// What the engine says, without what would help on a command line alone: "; give --average".
const without_options = (text) => text.replace(/(;|(?<=\?)) [^;?]*--[a-z][^]*$/, "");

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

// A state has a model, runs that it is fitted to, holdouts, and masks: [run, from, to] in seconds since power-on. One
// without an end is a cut, at which the bias begins anew.
const files_of = ({ runs, holdouts }) => [...runs, ...holdouts];
const mask_words = (state, masks = state.masks) =>
  masks.flatMap(([run, from, to]) => [
    to === null ? "--cut" : "--mask",
    (files_of(state).length > 1 ? run + ":" : "") + (to === null ? from : `${from}..${to}`),
  ]);
const masks_from = (words, files) =>
  words.flatMap((word, i) => {
    if (words[i - 1] !== "--mask" && words[i - 1] !== "--cut") return [];
    const [, run, from, to] = word.match(/^(?:(.*):)?([^:]*?)(?:\.\.([^:]*))?$/);
    return (run ? [run] : files).map((name) => [name, Number(from), to === undefined ? null : Number(to)]);
  });

// The command lines: recordings, holdouts, options for reading them, masks.
const judged_by = ({ holdouts }) => holdouts.flatMap((name) => ["--holdout", name]);
// `rows`: the current model's options of the fit's rows (rows_of).
const fit_words = (state, effects, expressions, model, rows = []) => [
  "fit",
  ...state.runs,
  ...setup.reading,
  ...mask_words(
    state,
    state.masks.filter(([run]) => state.runs.includes(run)),
  ),
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
const add_words = (state, what, model, verb = "add") => [
  verb,
  state.model,
  ...(what.expression ? [] : what.effects),
  ...state.runs,
  ...judged_by(state),
  ...setup.reading,
  ...mask_words(state),
  ...(what.expression ? ["--effect-expr", what.expression] : []),
  ...(what.run_offsets ? ["--run-offsets"] : []),
  "-o",
  model,
];
const compare_words = (state) => ["compare", state.model, ...files_of(state), ...setup.reading, ...mask_words(state)];
// The plots of one file; `before`: another state, drawn beside it.
const plots_words = (state, file, before) => [
  "plots",
  state.model,
  file,
  ...(before ? ["--model", before.model] : []),
  ...setup.reading,
  ...mask_words(
    { runs: [file], holdouts: [] },
    state.masks.filter(([run]) => run === file),
  ),
];
const diagnose_words = (state) => [
  "diagnose",
  state.model,
  ...state.runs,
  ...judged_by(state),
  ...setup.reading,
  ...mask_words(state),
];

const words_of_terms = (view) => view.terms.map((term) => term.words);
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

// What a state changed of the one before.
const label_of = (state, before) => {
  const words = words_of_terms(state.view);
  if (!before) return words.join(", ");
  const old = words_of_terms(before.view);
  const gone = old.filter((one) => !words.includes(one));
  const came = words.filter((one) => !old.includes(one));
  const changed = came.filter((one) => gone.some((other) => effect_name(other) === effect_name(one)));
  const is_changed = (one) => changed.some((other) => effect_name(other) === effect_name(one));
  const names = (files) => files.map(base_name).join(", ");
  const less = (files, others) => files.filter((one) => !others.includes(one));
  const bands = (masks) =>
    masks.map(([, from, to]) => (to === null ? `cut at ${from} s` : `${from} to ${to} s`)).join(", ");
  const parts = [
    ...came.filter((one) => !is_changed(one)).map((one) => `+ ${one}`),
    ...gone.filter((one) => !is_changed(one)).map((one) => `− ${effect_name(one)}`),
    ...changed.map((one) => `${effect_name(one)}: ${one.split(":").slice(1).join(", ") || "shape free"}`),
    ...[
      [less(state.masks, before.masks), "mask"],
      [less(before.masks, state.masks), "unmask"],
    ]
      .filter(([masks]) => masks.length > 0)
      .map(([masks, verb]) => `${verb} ${bands(masks)}`),
    ...[
      [less(state.runs, before.runs), "fit to"],
      [less(state.holdouts, before.holdouts), "judge by"],
    ]
      .concat([[less(files_of(before), files_of(state)), "without"]])
      .filter(([files]) => files.length > 0)
      .map(([files, verb]) => `${verb} ${names(files)}`),
  ];
  return parts.join(", ") || "fitted again";
};
