// The catalogue on the left, findings on the right.
"use strict";
const percent = (share) => `${Math.round(100 * share)} %`;

// "0.1509 ± 0.0021": both to the second digit of the standard deviation.
const with_sigma = (value, sigma) => {
  if (!(sigma > 0) || !isFinite(sigma)) return significant(value);
  const places = Math.min(9, Math.max(0, 1 - Math.floor(Math.log10(sigma))));
  if (Math.abs(value) >= 1e6 || Math.abs(value) < 1e-6) return `${significant(value)} ± ${significant(sigma, 2)}`;
  return `${value.toFixed(places)} ± ${sigma.toFixed(places)}`;
};

// A slider over a shape parameter's range (linear, logarithmic or whole numbers), which shows the fit
// while it is dragged and fixes the parameter when released, and a button that lets the fit identify it. Esc cancels
// a drag.
const shape_control = (term, parameter, { change, drag }) => {
  const { name, unit, value, sigma, identified, left_out, min, max, logarithmic, whole } = parameter;
  const is_log = logarithmic && min > 0;
  const to = (x) => (is_log ? Math.log(x / min) / Math.log(max / min) : (x - min) / (max - min));
  const from = (s) => (is_log ? min * (max / min) ** s : min + s * (max - min));
  const figure = make("span", { className: "figure" });
  const say = (x, own) => {
    const found = own && identified ? with_sigma(x, sigma) : significant(x);
    figure.textContent =
      left_out && own
        ? `${name}: left out`
        : `${name} ${found}${unit ? " " + unit : ""}${own && !identified ? ", fixed" : ""}`;
    slider.ariaValueText = figure.textContent;
  };
  const steps = whole ? max - min : 400;
  const begin = Math.round(steps * to(Math.max(value, min)));
  let held = false;
  let left = false; // whether Esc cancelled the drag
  const slider = make("input", {
    type: "range",
    min: 0,
    max: steps,
    step: 1,
    value: begin,
    ariaLabel: `${name} of ${term.effect}`,
    oninput: () => {
      if (left) {
        leave();
        return;
      }
      say(rounded(), false);
      drag(with_parameter(term.words, name, rounded()));
    },
    onpointerdown: () => {
      held = true;
    },
    onpointerup: () =>
      setTimeout(() => {
        held = left = false;
      }), // after the change, if there is one
    onkeydown: (event) => {
      if (event.key === "Escape" && held) leave();
    },
    onchange: () => (left ? leave() : change(with_parameter(term.words, name, rounded()))),
  });
  say(value, true);
  const leave = () => {
    left = true;
    slider.value = begin;
    say(value, true);
    drag(null);
  };
  const rounded = () => {
    const x = from(slider.valueAsNumber / steps);
    return whole ? Math.round(x) : Number(x.toPrecision(4));
  };
  const free = whole
    ? ""
    : make("button", {
        type: "button",
        ariaPressed: String(identified),
        ariaLabel: `free ${name} of ${term.effect}`,
        textContent: "free",
        title: identified ? "Identified by the fit; press to fix it at this value" : "Press to let the fit identify it",
        onclick: () => change(with_parameter(term.words, name, identified ? Number(value.toPrecision(6)) : "?")),
      });
  return make("div", { className: "shape" }, figure, slider, free);
};

// A name that may break after its underscores.
const breakable = (name) => name.split(/(?<=_)/).flatMap((part, i) => (i > 0 ? [make("wbr"), part] : [part]));

// Details of a term of the model: coefficients, shape parameters, whose bias it leaves, doubts and notes.
const about_term = (term, notes, actions) => {
  const shapes = term.parameters.filter((one) => one.max > one.min);
  const figures = [
    ...term.coefficients,
    ...(term.is_expression ? shapes.map((one) => ({ ...one, symbol: one.name })) : []),
  ];
  const rows = figures.map(({ symbol, value, sigma, unit }) =>
    make(
      "tr",
      {},
      make("td", { textContent: symbol }),
      make("td", { className: "value", textContent: with_sigma(value, sigma) }),
      make("td", { textContent: unit }),
    ),
  );
  return [
    make("table", {}, make("tbody", {}, ...rows)),
    ...(term.is_expression ? [] : shapes.map((one) => shape_control(term, one, actions))),
    ...[term.doubt, ...notes.filter((note) => note.includes(`‘${term.effect}’`))]
      .filter(Boolean)
      .map((text) => make("p", { textContent: text })),
  ];
};

// The correlations of a model's parameters, as a triangle of coloured figures.
const correlation_table = ({ names, rows }) => {
  const share = (value) => Math.round(100 * Math.min(1, Math.abs(value)));
  const cell = (value) =>
    make("td", {
      textContent: Number(value.toFixed(2)).toFixed(2), // no -0.00
      style: `background:color-mix(in srgb, var(--${value > 0 ? "heating" : "cooling"}) ${share(value) / 2}%, transparent)`,
    });
  return make(
    "table",
    { className: "correlations" },
    make(
      "tbody",
      {},
      ...rows.map((row, i) =>
        make("tr", {}, make("th", { scope: "row", textContent: `${i + 1} ${names[i]}` }), ...row.slice(0, i).map(cell)),
      ),
    ),
    make(
      "tfoot",
      {},
      make(
        "tr",
        {},
        make("td"),
        ...names.slice(1).map((name, i) => make("th", { scope: "col", textContent: i + 1, title: names[i] })),
      ),
    ),
  );
};

// Details of an effect of the catalogue.
const about_effect = (effect) =>
  effect
    ? [
        make("p", { textContent: effect.title }),
        make("p", {}, make("code", { textContent: effect.equation })),
        make("p", { className: "faint", textContent: effect.signature }),
      ]
    : [];

// A line of the list of effects: checkbox, name (opens the details), figure. `why`: what the recordings
// lack to show the effect, "" if nothing; `hover`: previews the effect.
class EffectRow {
  constructor({ name, ticked, brings = "", strong = false, why = "", about, toggle, hover, open, opened }) {
    const box = make("input", {
      type: "checkbox",
      checked: ticked,
      id: `effect_${name}`,
      onchange: () => toggle(box.checked),
    });
    if (why && !ticked) box.disabled = true;
    const more = make("div", { className: "about", hidden: !opened.has(name) }, ...about);
    const title = make("button", {
      type: "button",
      className: "name",
      textContent: name,
      ariaExpanded: String(opened.has(name)),
      ariaLabel: `details of ${name}`,
      title: why,
      onclick: () => {
        more.hidden = !more.hidden;
        title.ariaExpanded = String(!more.hidden);
        if (more.hidden) opened.delete(name);
        else opened.add(name);
        if (!more.hidden && open) open();
      },
    });
    box.setAttribute("aria-label", name);
    const figure = make("span", { className: `brings${strong ? " strong" : ""}`, textContent: brings });
    const tick = make("label", { className: "tick" }, box);
    const row = make("div", { className: `effect${why ? " untestable" : ""}` }, tick, title, figure);
    if (hover && !why) {
      row.addEventListener("mouseenter", () => hover(true));
      row.addEventListener("mouseleave", () => hover(false));
      row.addEventListener("focusin", () => hover(true));
      row.addEventListener("focusout", () => hover(false));
    }
    this.element = make("li", {}, row, more);
  }
}

const opened_effects = new Set();
let known_untestable = []; // depends on the recordings alone: kept until the next diagnosis

const show_effects = (catalogue, view, notes, diagnosis, actions) => {
  const list = byId("effects");
  const focused = document.activeElement && document.activeElement.id;
  const group = (text) => make("li", { className: "group", textContent: text });
  const by_name = new Map(catalogue.map((effect) => [effect.effect, effect]));
  const shares = new Map((view.compare.runs[0].effects || []).map((one) => [one.effect, one.share]));
  const names = new Set(view.terms.map((term) => term.effect));
  const inside = view.terms.map(
    (term) =>
      new EffectRow({
        name: term.effect,
        ticked: true,
        opened: opened_effects,
        brings: term.effect === "bias" ? "" : shares.has(term.effect) ? percent(shares.get(term.effect)) : "",
        about: [...about_term(term, notes, actions), ...about_effect(by_name.get(term.effect))],
        toggle: () => actions.remove(term),
      }).element,
  );
  const candidates = new Map((diagnosis ? diagnosis.candidates : []).map((one) => [one.effect, one]));
  known_untestable = diagnosis ? diagnosis.untestable : known_untestable;
  const untestable = new Map(known_untestable.map((one) => [one.effect, one.needs]));
  const others = catalogue
    .filter((effect) => !names.has(effect.effect))
    .sort((a, b) => ((candidates.get(b.effect) || {}).lead || 0) - ((candidates.get(a.effect) || {}).lead || 0));
  const row = (effect) => {
    const candidate = candidates.get(effect.effect);
    return new EffectRow({
      name: effect.effect,
      ticked: false,
      opened: opened_effects,
      brings: candidate ? significant(candidate.visible_from_dph, 2) : "",
      strong: Boolean(candidate && candidate.lead > 0.5),
      why: untestable.has(effect.effect) ? `needs ${untestable.get(effect.effect)}` : "",
      about: [
        ...(untestable.has(effect.effect)
          ? [make("p", { textContent: `Not visible in these recordings: needs ${untestable.get(effect.effect)}.` })]
          : []),
        ...about_effect(effect),
      ],
      toggle: () => actions.add(effect.effect),
      hover: (on) => actions.preview(effect.effect, on),
    }).element;
  };
  const can = others.filter((effect) => !untestable.has(effect.effect));
  const cannot = others.filter((effect) => untestable.has(effect.effect));
  list.replaceChildren(
    group("In the model; share of the drift"),
    ...inside,
    group(diagnosis ? "To add; would have been seen from, °/h" : "To add"),
    ...can.map(row),
    ...(cannot.length ? [group("Not visible in these recordings"), ...cannot.map(row)] : []),
  );
  if (focused && focused.startsWith("effect_") && byId(focused)) byId(focused).focus();
};

// The rms of the residual in the worst run of a state: of the runs fitted to, and of the holdouts.
const worst = (runs, value) => Math.max(...runs.map(value));
const errors_of = ({ view, holdouts }) => {
  const of = (held) => {
    const runs = view.compare.runs.filter(({ file }) => holdouts.includes(file) === held);
    return runs.length ? worst(runs, (run) => run.residual_rms_dph) : null;
  };
  return { fitted: of(false), judged: of(true) };
};

// A bar of `value` in the colour `name`; `place` gives its end as a percentage, `floor`: dashed line.
const bar = (value, place, floor, name) =>
  make(
    "span",
    { className: "bar" },
    make(
      "span",
      { className: "track" },
      make("span", { className: "fill", style: `width:${place(value)}%;background:var(--${name})` }),
      ...(floor ? [make("span", { className: "mark", style: `left:${place(floor)}%` })] : []),
    ),
    make("span", { className: "value", textContent: rms(value) }),
  );

// A linear scale of bars, or a logarithmic one from half of the least where that would be a few pixels.
const scale_of = (values) => {
  const full = Math.max(...values);
  const least = Math.min(...values.filter((value) => value > 0)) / 2;
  const logarithmic = full > 50 * least;
  const share = (value) => (logarithmic ? Math.log(value / least) / Math.log(full / least) : value / full);
  return { logarithmic, place: (value) => (100 * Math.min(1, Math.max(0, share(value)))).toFixed(1) };
};

// The error ladder: what a constant leaves, then each state, with buttons that go to them.
const show_ladder = (go) => {
  const first = states.list[0];
  const runs = first.view.compare.runs;
  const floor = worst(runs, (run) => run.noise_floor_dph || 0) || null;
  const is_constant = first.view.terms.every(({ effect }) => effect === "bias");
  const raw = is_constant ? null : worst(runs, (run) => run.raw_std_dph);
  const errors = states.list.map(errors_of);
  const all = [raw, floor, ...errors.flatMap(({ fitted, judged }) => [fitted, judged])];
  const { logarithmic, place } = scale_of(all.filter((value) => value !== null));
  const rows = states.list.map((state, i) =>
    make(
      "li",
      {},
      make(
        "button",
        {
          type: "button",
          className: i > states.at ? "later" : "",
          onclick: () => go(i),
          ...(i === states.at ? { ariaCurrent: "step" } : {}),
        },
        make("span", { className: "what", textContent: state.label }),
        bar(errors[i].fitted, place, floor, "residual"),
        ...(errors[i].judged === null ? [] : [bar(errors[i].judged, place, null, "second")]),
      ),
    ),
  );
  const { runs: fitted, holdouts } = states.now;
  const legend = make(
    "li",
    { className: "legend" },
    `°/h rms${fitted.length > 1 ? " of the worst run" : ""}${logarithmic ? ", logarithmic" : ""}`,
    floor ? `; dashed: the noise floor, ${rms(floor)}` : "",
    ...(holdouts.length
      ? ["; ", make("span", { className: "key", style: "background:var(--second)" }), " on holdouts"]
      : []),
  );
  byId("ladder").replaceChildren(
    ...(raw === null
      ? []
      : [
          make(
            "li",
            {},
            make("span", { className: "what", textContent: "a constant alone" }),
            bar(raw, place, floor, "measured"),
          ),
        ]),
    ...rows,
    legend,
  );
};

// Whether the last step helps out of sample.
const judgement_of = ({ judged }) =>
  judged
    ? [
        make(
          "p",
          { className: `judged${judged.good ? " good" : ""}` },
          judged.reason + " ",
          ...(judged.anyway
            ? [make("button", { type: "button", textContent: "Add it anyway", onclick: judged.anyway })]
            : []),
        ),
      ]
    : [];

const paragraphs = (lines, className = "") =>
  lines.filter(Boolean).map((line) => make("p", { className, textContent: line }));

// The candidates: how probable, and what each leaves alone.
const candidate_table = (diagnosis, actions) => {
  const rivals = diagnosis.candidates.filter((one) => one.lead > 0.001 || one.explained_fraction > 0.1).slice(0, 7);
  if (rivals.length === 0) return [];
  const heads = [
    ["candidate", "Effect that may be missing"],
    ["largest", "Probability that it is the largest of the missing effects"],
    ["explains", "Share of what is above the noise, by it alone"],
    ["rms left", "Residual of the refitted model with it alone added, °/h"],
    ["", ""],
  ];
  const cells = (...texts) => texts.map((textContent) => make("td", { textContent }));
  const rows = rivals.map((one) => {
    const add = make("button", {
      type: "button",
      textContent: "+",
      title: `Add ${one.effect} if it helps out of sample`,
      ariaLabel: `Add ${one.effect}`,
      onclick: () => actions.judge({ effects: [one.effect] }),
    });
    return make(
      "tr",
      {
        onmouseenter: () => actions.preview(one.effect, true),
        onmouseleave: () => actions.preview(one.effect, false),
      },
      make("td", {}, ...breakable(one.effect)),
      ...cells(percent(one.lead), percent(one.explained_fraction), rms(one.rms_after_dph, 3)),
      make("td", {}, add),
    );
  });
  const now = make(
    "tr",
    { className: "faint" },
    ...cells("none of them", "", "", rms(diagnosis.residual_rms_dph, 3), ""),
  );
  return [
    make(
      "table",
      {},
      make(
        "thead",
        {},
        make("tr", {}, ...heads.map(([textContent, title]) => make("th", { textContent, title, scope: "col" }))),
      ),
      make("tbody", {}, ...rows, now),
    ),
  ];
};

// The judgement of the last step and the diagnosis of a state; the focus stays.
const show_diagnosis = (state, actions) => {
  const place = byId("diagnosis");
  const had_focus = place.contains(document.activeElement);
  fill_diagnosis(place, state, actions);
  if (had_focus) (byId("add_missing") || byId("stop_diagnosis") || place).focus();
};
const fill_diagnosis = (place, state, actions) => {
  byId("candidates").replaceChildren();
  if (!state.diagnosis) {
    const stopped = Boolean(state.trouble);
    place.replaceChildren(
      ...judgement_of(state),
      make("p", { className: "faint", id: "progress", textContent: state.trouble || "Diagnosing …" }),
      make("button", {
        type: "button",
        id: "stop_diagnosis",
        textContent: stopped ? "Diagnose" : "Stop",
        onclick: stopped ? actions.diagnose : actions.stop,
      }),
    );
    return;
  }
  const { words, diagnosis, add } = state.diagnosis;
  const button = () =>
    make("button", {
      type: "button",
      className: "main",
      id: "add_missing",
      textContent:
        add.expression || add.effects.length
          ? `Add ${add.expression || add.effects.join(" and ")}`
          : `Let the bias begin anew at ${add.cuts[0].at_s} s`,
      onclick: () => actions.judge(add),
    });
  place.replaceChildren(
    ...judgement_of(state),
    ...paragraphs([words.verdict], "verdict"),
    ...paragraphs([words.certainty]),
    ...(add ? [make("p", {}, button())] : []),
    ...paragraphs([words.next]),
  );
  byId("candidates").replaceChildren(
    ...candidate_table(diagnosis, actions),
    ...paragraphs(words.findings),
    ...(words.limits.length
      ? [make("details", {}, make("summary", { textContent: "Limits of this diagnosis" }), ...paragraphs(words.limits))]
      : []),
  );
};
