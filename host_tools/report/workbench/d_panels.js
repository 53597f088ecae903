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

// A slider over a shape parameter's range (linear, logarithmic or whole numbers), which fixes the
// parameter when released, and a button that lets the fit identify it. Esc cancels a drag.
const shape_control = (term, parameter, change) => {
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
    oninput: () => (left ? leave() : say(rounded(), false)),
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
const about_term = (term, notes, change) => {
  const rows = term.coefficients.map(({ symbol, value, sigma, unit }) =>
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
    ...(term.is_expression
      ? []
      : term.parameters.filter((one) => one.max > one.min).map((one) => shape_control(term, one, change))),
    ...[term.step, term.doubt, ...notes.filter((note) => note.includes(`‘${term.effect}’`))]
      .filter(Boolean)
      .map((text) => make("p", { textContent: text })),
  ];
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
    const row = make("div", { className: `effect${why ? " untestable" : ""}` }, box, title, figure);
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
        about: [...about_term(term, notes, actions.change), ...about_effect(by_name.get(term.effect))],
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
      brings: candidate ? rms(candidate.rms_after_dph, 3) : "",
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
    group(diagnosis ? "To add; rms left with it, °/h" : "To add"),
    ...can.map(row),
    ...(cannot.length ? [group("Not visible in these recordings"), ...cannot.map(row)] : []),
  );
  if (focused && focused.startsWith("effect_") && byId(focused)) byId(focused).focus();
};

// The rms of the residual in the worst run of a state: of the runs fitted to, and of the holdouts.
const worst = (runs) => runs.reduce((max, run) => Math.max(max, run.residual_rms_dph), 0);
const errors_of = (view) => ({
  fitted: worst(view.compare.runs.filter(({ file }) => !setup.holdouts.includes(file))),
  judged: setup.holdouts.length ? worst(view.compare.runs.filter(({ file }) => setup.holdouts.includes(file))) : null,
});

// A bar of `value` in the colour `name`; `full`: the value of the whole width, `floor`: dashed line.
const bar = (value, full, floor, name) =>
  make(
    "span",
    { className: "bar" },
    make(
      "span",
      { className: "track" },
      make("span", {
        className: "fill",
        style: `width:${Math.min(100, (100 * value) / full).toFixed(1)}%;background:var(--${name})`,
      }),
      ...(floor
        ? [make("span", { className: "mark", style: `left:${Math.min(100, (100 * floor) / full).toFixed(1)}%` })]
        : []),
    ),
    make("span", { className: "value", textContent: rms(value) }),
  );

// The error ladder: measured, then each state, with buttons that go to them.
const show_ladder = (go) => {
  const first = states.list[0].view.compare.runs;
  const floor = Math.max(...first.map((run) => run.noise_floor_dph || 0)) || null;
  const raw = Math.max(...first.map((run) => run.raw_std_dph));
  const full = Math.max(raw, ...states.list.map((state) => errors_of(state.view).fitted));
  const rows = states.list.map((state, i) => {
    const { fitted, judged } = errors_of(state.view);
    return make(
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
        bar(fitted, full, floor, "residual"),
        ...(judged === null ? [] : [bar(judged, full, null, "second")]),
      ),
    );
  });
  const keys = [`°/h rms${floor ? `; dashed: the noise floor, ${rms(floor)}` : ""}`];
  const legend = make(
    "li",
    { className: "legend" },
    ...keys,
    ...(setup.holdouts.length
      ? ["; ", make("span", { className: "key", style: "background:var(--second)" }), " on holdouts"]
      : []),
  );
  byId("ladder").replaceChildren(
    make("li", {}, make("span", { className: "what", textContent: "measured" }), bar(raw, full, floor, "measured")),
    ...rows,
    legend,
  );
};

// The judgement of the last addition and the diagnosis of a state.
const show_diagnosis = (state, actions) => {
  const place = byId("diagnosis");
  const judged = state.judged
    ? [
        make(
          "p",
          { className: `judged${state.judged.good ? " good" : ""}` },
          state.judged.reason + " ",
          ...(state.judged.anyway
            ? [make("button", { type: "button", textContent: "Add it anyway", onclick: state.judged.anyway })]
            : []),
        ),
      ]
    : [];
  if (!state.diagnosis) {
    place.replaceChildren(...judged, make("p", { className: "faint", textContent: state.trouble || "Diagnosing …" }));
    return;
  }
  const { words, diagnosis, add } = state.diagnosis;
  const paragraphs = (lines, className = "") =>
    lines.filter(Boolean).map((line) => make("p", { className, textContent: line }));
  const button = add
    ? [
        make(
          "p",
          {},
          make("button", {
            type: "button",
            className: "main",
            id: "add_missing",
            textContent: add.expression ? `Add ${add.expression}` : `Add ${add.effects.join(" and ")}`,
            onclick: () => actions.judge(add),
          }),
        ),
      ]
    : [];
  const rivals = diagnosis.candidates.filter((one) => one.lead > 0.001 || one.explained_fraction > 0.1).slice(0, 7);
  const table = rivals.length
    ? [
        make(
          "table",
          {},
          make(
            "thead",
            {},
            make(
              "tr",
              {},
              ...[
                ["candidate", "Effect that may be missing"],
                ["largest", "Probability that it is the largest of the missing effects"],
                ["explains", "Share of what is above the noise, by it alone"],
                ["rms left", "Residual with it alone added, °/h"],
                ["", ""],
              ].map(([text, title]) => make("th", { textContent: text, title, scope: "col" })),
            ),
          ),
          make(
            "tbody",
            {},
            ...rivals.map((one) => {
              const row = make(
                "tr",
                {},
                make("td", {}, ...breakable(one.effect)),
                make("td", { textContent: percent(one.lead) }),
                make("td", { textContent: percent(one.explained_fraction) }),
                make("td", { textContent: rms(one.rms_after_dph, 3) }),
                make(
                  "td",
                  {},
                  make("button", {
                    type: "button",
                    textContent: "+",
                    title: `Add ${one.effect} if it helps out of sample`,
                    ariaLabel: `Add ${one.effect}`,
                    onclick: () => actions.judge({ effects: [one.effect] }),
                  }),
                ),
              );
              row.addEventListener("mouseenter", () => actions.preview(one.effect, true));
              row.addEventListener("mouseleave", () => actions.preview(one.effect, false));
              return row;
            }),
          ),
        ),
      ]
    : [];
  place.replaceChildren(
    ...judged,
    ...paragraphs([words.verdict], "verdict"),
    ...paragraphs([words.certainty]),
    ...button,
    ...paragraphs([words.next]),
    ...table,
    ...paragraphs(words.findings),
    ...(words.limits.length
      ? [make("details", {}, make("summary", { textContent: "Limits of this diagnosis" }), ...paragraphs(words.limits))]
      : []),
  );
};
