// The page's behaviour: a change becomes a command, the command a state; the state is shown and then
// diagnosed in the background.
"use strict";
(async () => {
  let fitting = null; // engine of the user's changes
  let diagnosing = null; // engine of the diagnosis, which takes longer
  let previewing = null; // engine of the preview of the candidate under the mouse
  let catalogue = [];
  let run = 0;
  const axes = { x: null, y: "residual_dph" }; // of the third plot; x null: the strongest variable
  const columns = [
    "time_s",
    "gap_before",
    "outlier",
    "branch",
    "measured_dph",
    "modelled_dph",
    "residual_dph",
    "temperature_degc",
    "temperature_rate",
    "temperature_degc x temperature_rate",
  ];

  // Shows an error, or hides the last one.
  const trouble = (what) => {
    byId("trouble").textContent = without_options(what || "");
    byId("trouble").hidden = !what;
  };
  const working = (stage, done) => {
    byId("working").hidden = stage === null;
    byId("working").firstElementChild.style.width = `${100 * (done || 0)}%`;
  };

  // The answer of an engine; throws its error.
  const checked = ({ found, values }) => {
    if (found.error) throw new Error(found.error);
    return { ...found, values };
  };

  // Gives a model file to all engines.
  const keep_model = (name, text) => {
    const bytes = new TextEncoder().encode(text);
    [fitting, diagnosing, previewing].forEach((engine) => engine.put(name, bytes));
  };

  // What is shown of a state's model: its comparison with the runs, and their columns.
  const view_of = async (state) => {
    const inputs = setup.columns || [];
    const view = checked(await fitting.call(compare_words(state), [...columns, ...inputs]));
    // Optional columns are known only after the first answer: asks again with them.
    const more = view.runs
      .flatMap((one) => one.variables.map(({ name }) => name))
      .filter((name) => ![...columns, ...inputs].includes(name));
    if (more.length === 0) return view;
    setup.columns = [...inputs, ...new Set(more)];
    return view_of(state);
  };

  // The state that a command makes, or only its answer where `add` refuses.
  const made_by = async (words, { masks, runs, holdouts }) => {
    const before = states.now;
    const model = words[words.indexOf("-o") + 1];
    const answer = checked(await fitting.call(words));
    if (!answer.text) return { answer };
    keep_model(model, answer.text);
    states.reserve(model);
    const state = { model, words, masks, runs, holdouts };
    state.notes = answer.remarks;
    if (answer.add) state.judged = { good: answer.add.accepted, reason: answer.reason };
    state.view = await view_of(state);
    state.label = label_of(state, before);
    return { answer, state };
  };

  // Waits for a pause of the user; a change that is being fitted comes first. Of several calls in this
  // time the last one counts. An effect that was ticked is judged first.
  let asked = 0;
  const diagnose = async (state) => {
    const turn = ++asked;
    diagnosing.cancel();
    await new Promise((done) => setTimeout(done, 300));
    if (turn !== asked || states.now !== state || changing > 0) return;
    try {
      if (state.ticked) {
        const { before, effect } = state.ticked;
        const words = add_words(before, { effects: [effect] }, "ticked.model");
        const { add, reason } = checked(await diagnosing.call(words));
        state.judged = { good: add.accepted, reason };
        state.ticked = null;
        show_findings();
      }
      state.diagnosis = checked(await diagnosing.call(diagnose_words(state)));
    } catch (fault) {
      if (fault instanceof Cancelled) return;
      state.trouble = fault.message;
    }
    if (states.now !== state) return;
    show_findings();
    if (axes.x || !state.diagnosis) return;
    show_axes(state);
    draw_third();
  };
  const diagnosed_by = (stage, done) => {
    if (stage !== null && byId("progress")) byId("progress").textContent = `Diagnosing: ${percent(done || 0)}`;
  };

  const show_findings = () => {
    const state = states.now;
    show_effects(catalogue, state.view, state.notes || [], state.diagnosis && state.diagnosis.diagnosis, actions);
    show_diagnosis(state, actions);
    document.body.dataset.diagnosed = state.diagnosis ? "yes" : "no";
  };

  const option = (value, textContent, chosen) => make("option", { value, textContent, selected: value === chosen });
  const show_runs = (state) => {
    const { view, holdouts } = state;
    byId("runs").replaceChildren(
      ...view.runs.map(({ file }, i) =>
        make("button", {
          type: "button",
          textContent: base_name(file) + (holdouts.includes(file) ? " (holdout)" : ""),
          ariaPressed: String(i === run),
          onclick: () => {
            run = i;
            show();
          },
        }),
      ),
    );
    const last_fit = state.runs.length === 1 && state.runs.includes(name_of_run());
    byId("run_use").replaceChildren(
      option("fit", "fit to it", ""),
      option("holdout", "judge by it", holdouts.includes(name_of_run()) ? "holdout" : ""),
      option("remove", "leave it out", ""),
    );
    byId("run_use").disabled = last_fit;
    byId("run_use").title = last_fit ? "The only recording to fit to" : "What this recording is for";
    show_axes(state);
  };
  // A diagnosis changes these alone: a button that it replaced would lose the click that is on its way.
  const show_axes = (state) => {
    const { variables } = state.view.runs[run];
    const chosen = axes.x || strongest(state, run);
    const group = (label, options) => make("optgroup", { label }, ...options);
    byId("variable").replaceChildren(
      group(
        "over",
        variables.map(({ name, label }) => option(name, label, chosen)),
      ),
      group(
        "or of the residual",
        titles.map((title) => option(title, title.replace(/\.$/, ""), chosen)),
      ),
      group("or of the model", [option(correlations, correlations, chosen)]),
    );
    byId("quantity").replaceChildren(
      option("residual_dph", "residual, °/h", axes.y),
      ...variables.map(({ name, label }) => option(name, label, axes.y)),
    );
  };

  const show = () => {
    const { view } = states.now;
    run = Math.min(run, view.runs.length - 1);
    show_runs(states.now);
    draw();
    const [found, ...rest] = view.runs[run].words;
    byId("found").textContent = found;
    byId("depends").textContent = rest.join(" ");
    show_ladder(go);
    show_findings();
    byId("commands").textContent =
      states
        .commands()
        .map((words) => "$ " + shell_line(words))
        .join("\n") || `$ ${shell_line(compare_words(states.now))}`;
    show_masks();
    const notes = [...(setup.notes || []), ...(states.now.notes || [])];
    byId("notes").replaceChildren(...notes.map((note) => make("li", { textContent: without_options(note) })));
    byId("notes_box").hidden = notes.length === 0;
    if (notes.some((note) => note.endsWith("?"))) byId("notes_box").open = true;
    byId("undo").disabled = states.at <= 0;
    byId("redo").disabled = states.at >= states.list.length - 1;
    document.body.dataset.state = states.at;
    remember();
  };

  // The address has the steps since the page was opened, so that a reload or a link begins with them.
  const remember = () => {
    const steps = states.list.filter((state) => state.words && !state.given);
    const are_few = steps.length === 0 || (steps.length === 1 && setup.states.length === 0);
    const kept = { at: states.at, steps: steps.map(({ words, masks, holdouts }) => [words, masks, holdouts]) };
    const hash = are_few && states.at === states.list.length - 1 ? "" : "#" + encodeURIComponent(JSON.stringify(kept));
    if (hash !== location.hash) history.replaceState(null, "", hash || location.href.split("#")[0]);
  };

  const go = (index) => {
    states.go(index);
    preview(null, false);
    trouble("");
    show();
    if (!states.now.diagnosis) diagnose(states.now);
  };

  // Runs changes one after the other.
  let last = Promise.resolve();
  let changing = 0;
  const in_turn = (work) => {
    ++changing;
    diagnosing.cancel();
    previewing.cancel();
    last = last
      .then(work)
      .catch((fault) => {
        trouble(fault.message);
        if (states.now) show();
      })
      .then(() => {
        if (--changing === 0 && states.now && !states.now.diagnosis) diagnose(states.now);
      });
    return last;
  };

  const enter = (state) => {
    states.push(state);
    trouble("");
    byId("candidate").textContent = "";
    show();
  };

  // Fits a changed model: `change` returns what it changes of { effects, expressions, masks, runs, holdouts }.
  const fit = (change) =>
    in_turn(async () => {
      const now = states.now;
      const before = now
        ? { ...now, effects: effects_of(now.view), expressions: expressions_of(now.view) }
        : { ...setup, effects: ["bias"], expressions: [], masks: masks_from(setup.masks, files_of(setup)) };
      const changed = change(before);
      const after = { ...before, ...changed };
      const model = states.next_model();
      const words = fit_words(after, after.effects, after.expressions, model, now ? rows_of(now.view) : []);
      const { state } = await made_by(words, after);
      state.ticked = changed.ticked && { before: now, effect: changed.ticked };
      enter(state);
    });

  // Adds effects or an expression if `add` accepts them out of sample; `force`: in any case.
  const judge = (what, force = false) =>
    in_turn(async () => {
      const cuts = (what.cuts || []).map(({ run, at_s }) => [run || states.now.runs[0], at_s, null]);
      const after = cuts.length ? { ...states.now, masks: [...states.now.masks, ...cuts] } : states.now;
      const words = [...add_words(after, what, states.next_model()), ...(force ? ["--force"] : [])];
      const { answer, state } = await made_by(words, after);
      if (state) {
        enter(state);
        return;
      }
      states.now.judged = { good: false, reason: `Not added. ${answer.reason}`, anyway: () => judge(what, true) };
      show_findings();
    });

  // Draws the candidate under the mouse over the residual; a change does not wait for it.
  let wanted = null;
  const preview = async (effect, on) => {
    wanted = on ? effect : null;
    const state = states.now;
    if (!on) {
      if (byId("candidate").textContent === "") return;
      state.view.values.forEach((values) => {
        delete values.preview;
      });
      byId("candidate").textContent = "";
      draw();
      return;
    }
    if (!state) return;
    await new Promise((done) => setTimeout(done, 150));
    if (wanted !== effect || changing > 0) return;
    state.previews = state.previews || new Map();
    if (!state.previews.has(effect)) {
      previewing.cancel();
      const words = add_words(state, { effects: [effect] }, "preview.model", "preview");
      const answer = await previewing.call(words, ["preview"]).catch(() => null);
      if (!answer) return; // something else is wanted by now
      state.previews.set(effect, answer);
    }
    if (wanted !== effect || states.now !== state) return;
    const { found, values } = state.previews.get(effect);
    byId("candidate").textContent = found.error || `with ${effect}: ${rms(found.rms_after_dph)} rms`;
    // Not drawn for files of one run, which the engine joins and the page shows one by one.
    values.forEach((one, i) => {
      const shown = state.view.values[i];
      if (one.preview && shown && one.preview.length === shown.time_s.length) shown.preview = one.preview;
    });
    draw();
  };

  const with_changed = (effects, changed) =>
    effects.map((words) => (effect_name(words) === effect_name(changed) ? changed : words));

  // Shows the fit with the shape at which a slider is held; the state stays. `changed`: the words of the effect; null:
  // the slider was let go.
  let dragged = null;
  let following = false;
  const drag = async (changed) => {
    dragged = changed;
    if (changed === null && byId("candidate").textContent !== "") {
      byId("candidate").textContent = "";
      draw();
    }
    if (following) return;
    following = true;
    const state = states.now;
    const is_wanted = () => dragged !== null && changing === 0 && states.now === state;
    for (let shown = null; is_wanted() && shown !== dragged; ) {
      shown = dragged;
      const held = { ...state, model: "dragged.model" };
      const effects = with_changed(effects_of(state.view), shown);
      const words = fit_words(state, effects, expressions_of(state.view), held.model, rows_of(state.view));
      const said = await fitting
        .call(words)
        .then(checked)
        .then(() => view_of(held))
        .then((view) => {
          if (is_wanted()) draw(view);
          return `${shown}: ${rms(errors_of({ ...held, view }).fitted)} rms`;
        })
        .catch((fault) => fault.message);
      if (is_wanted()) byId("candidate").textContent = said;
    }
    following = false;
  };

  const actions = {
    add: (effect) => fit(({ effects }) => ({ effects: [...effects, effect], ticked: effect })),
    remove: (term) =>
      fit(({ effects, expressions }) => ({
        effects: effects.filter((words) => effect_name(words) !== term.effect),
        expressions: expressions.filter((words) => words !== term.words),
      })),
    change: (changed) => {
      dragged = null;
      fit(({ effects }) => ({ effects: with_changed(effects, changed) }));
    },
    drag,
    judge,
    preview,
    stop: () => {
      ++asked;
      diagnosing.cancel();
      states.now.trouble = "Not diagnosed.";
      show_findings();
    },
    diagnose: () => {
      states.now.trouble = null;
      show_findings();
      diagnose(states.now);
    },
  };

  // Draws the shown run with its masks, by the state's model or by one that is tried.
  const draw = (view = states.now.view) => {
    const { masks } = states.now;
    const name = name_of_run();
    const other = byId("show_before").ariaPressed === "true" ? last_with(name) : null;
    draw_run(view, run, {
      masks: masks.filter(([of]) => of === name).map(([, from, to]) => [from, to === null ? from + 30 : to]),
      selected: masking() ? select_mask : null,
      before: other && other.values.residual_dph,
    });
    draw_third(view);
  };
  // The step before with the same rows of this file, or null.
  const last_with = (name) => {
    const state = states.list[states.at - 1];
    const index = state ? state.view.runs.findIndex(({ file }) => file === name) : -1;
    if (index < 0) return null;
    const values = state.view.values[index];
    return values.time_s.length === states.now.view.values[run].time_s.length ? { state, values } : null;
  };

  // The engine's drawings of what is left of the shown run, beside those of the step before.
  const drawings_of = (state) => {
    const name = name_of_run();
    state.drawings = state.drawings || new Map();
    if (!state.drawings.has(name)) {
      const other = last_with(name);
      const names = new Map([[base_name(state.model), "this step"]]);
      if (other) names.set(base_name(other.state.model), "step before");
      const asked = fitting.call(plots_words(state, name, other && other.state)).then((answer) => {
        const { plots: all } = checked(answer);
        all.forEach((plot) =>
          plot.curves.forEach((curve) => {
            curve.label = names.get(curve.label) || curve.label;
          }),
        );
        return all;
      });
      state.drawings.set(name, asked);
    }
    return state.drawings.get(name);
  };

  // The third plot: the rows, one of the drawings, or the model's correlations.
  const correlations = "correlations of the parameters";
  let titles = [];
  let erase = null;
  const draw_third = async (view = states.now.view) => {
    const state = states.now;
    const over = axes.x || strongest(state, run);
    const is_matrix = over === correlations;
    const is_drawing = titles.includes(over);
    byId("variable_plot").hidden = byId("variable_read").hidden = byId("branches").hidden = is_drawing || is_matrix;
    byId("drawing").hidden = !is_drawing;
    byId("matrix").hidden = !is_matrix;
    byId("drawing_caption").hidden = !is_drawing && !is_matrix;
    byId("quantity").disabled = is_drawing || is_matrix;
    if (erase) erase();
    erase = null;
    if (is_matrix) {
      byId("matrix").replaceChildren(...(view.correlations ? [correlation_table(view.correlations)] : []));
      byId("drawing_caption").textContent = view.correlations
        ? "From −1 to 1. Near either, these recordings tell the sum of two parameters, or their difference, and not each."
        : "These recordings do not determine the parameters.";
      return;
    }
    if (!is_drawing) {
      draw_variable(view, run, over, axes.y);
      return;
    }
    const all = await drawings_of(state).catch((fault) => {
      trouble(fault.message);
      return [];
    });
    if (states.now !== state || axes.x !== over || erase) return;
    const plot = all.find(({ title }) => title === over);
    if (plot) erase = draw_plot(byId("drawing"), structuredClone(plot));
    byId("drawing_caption").textContent = plot ? plot.caption : "This recording is too short for it.";
  };
  const name_of_run = () => states.now.view.runs[run].file;
  const masking = () => byId("mask_mode").ariaPressed === "true";
  const mask = (from, to) => fit(({ masks }) => ({ masks: [...masks, [name_of_run(), from, to]] }));
  const select_mask = (u) => {
    if (u.select.width < 3) return;
    const [from, to] = [u.select.left, u.select.left + u.select.width].map((x) =>
      Math.round(3600 * u.posToVal(x, "x")),
    );
    set_masking(false);
    mask(from, to);
  };
  const set_masking = (on) => {
    byId("mask_mode").ariaPressed = String(on);
    byId("residual_plot").classList.toggle("masking", on);
    plots.residual.u.cursor.drag.setScale = !on;
    draw();
  };
  const show_masks = () =>
    byId("masks").replaceChildren(
      ...states.now.masks.map((one) =>
        make(
          "li",
          {},
          make("button", {
            type: "button",
            title: one[2] === null ? "Remove this cut" : "Remove this mask",
            ariaLabel: `remove the ${one[2] === null ? "cut" : "mask"} ${base_name(one[0])} ${one[1]}${one[2] === null ? "" : ` to ${one[2]}`} s`,
            textContent: `${base_name(one[0])} ${one[2] === null ? `cut at ${one[1]}` : `${one[1]}..${one[2]}`} s ×`,
            onclick: () => fit(({ masks }) => ({ masks: masks.filter((other) => other !== one) })),
          }),
        ),
      ),
    );
  byId("mask_mode").onclick = () => set_masking(!masking());
  byId("masking").onsubmit = (event) => {
    event.preventDefault();
    const [from, to] = ["mask_from", "mask_to"].map((id) => Number(byId(id).value.replace(",", ".") || NaN));
    if (from < to) mask(from, to);
    else trouble("Mask: give two times in seconds since power-on, the earlier one first.");
  };

  const save = (name, text) => {
    const link = make("a", { href: URL.createObjectURL(new Blob([text])), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  };
  const copy = async (text, button) => {
    const said = button.textContent;
    await navigator.clipboard.writeText(text).then(
      () => {
        button.textContent = "Copied";
      },
      () => {
        trouble(text);
      },
    );
    setTimeout(() => {
      button.textContent = said;
    }, 1200);
  };

  byId("undo").onclick = () => go(states.at - 1);
  byId("redo").onclick = () => go(states.at + 1);
  byId("variable").onchange = () => {
    axes.x = byId("variable").value;
    draw_third();
  };
  byId("quantity").onchange = () => {
    axes.y = byId("quantity").value;
    draw_third();
  };
  byId("show_before").onclick = () => {
    byId("show_before").ariaPressed = String(byId("show_before").ariaPressed !== "true");
    draw();
  };
  byId("run_use").onchange = () => {
    const name = name_of_run();
    const use = byId("run_use").value;
    const with_it = (files, wanted) => [...files.filter((one) => one !== name), ...(use === wanted ? [name] : [])];
    fit(({ runs, holdouts, masks }) => ({
      runs: with_it(runs, "fit"),
      holdouts: with_it(holdouts, "holdout"),
      masks: use === "remove" ? masks.filter(([of]) => of !== name) : masks,
    }));
  };
  // A click in a plot that masks by drag masks the row under the cursor.
  byId("residual_plot").addEventListener("click", () => {
    const { cursor, select, data } = plots.residual.u;
    if (!masking() || cursor.idx == null || select.width >= 3) return;
    const half_s = states.now.view.compare.runs[run].row_s / 2;
    const time_s = 3600 * data[0][cursor.idx];
    set_masking(false);
    mask(Math.floor(time_s - half_s), Math.ceil(time_s + half_s));
  });
  byId("save_model").onclick = () => save(base_name(states.now.model), states.now.view.text);
  const save_written = (name, words) =>
    in_turn(async () => save(name, checked(await fitting.call([...words, "-o", name])).text));
  byId("save_header").onclick = () => save_written("fog_model.h", ["export", states.now.model]);
  byId("save_rows").onclick = () =>
    save_written("compensated.csv", ["apply", states.now.model, name_of_run(), ...setup.reading]);
  byId("save_report").onclick = () =>
    in_turn(async () => {
      const file = "report.html";
      save(file, checked(await fitting.call(["history", states.now.model, "--report", file])).text);
    });
  byId("copy_commands").onclick = () => copy(byId("commands").textContent.replaceAll("$ ", ""), byId("copy_commands"));
  byId("link").onclick = () => copy(location.href, byId("link"));
  addEventListener("keydown", (event) => {
    if (event.key === "Escape" && !Object.values(plots).some((plot) => plot.cancel_drag()) && changing > 0)
      fitting.cancel();
    if (!(event.ctrlKey || event.metaKey) || event.target.matches("input:not([type])")) return;
    const key = event.key.toLowerCase();
    if (key === "z" && !event.shiftKey) byId("undo").click();
    else if (key === "y" || (key === "z" && event.shiftKey)) byId("redo").click();
    else return;
    event.preventDefault();
  });

  // Checks a formula as it is typed.
  byId("expression").oninput = () => {
    const text = byId("expression").value.trim();
    if (!text) {
      byId("formula_error").textContent = "";
      return;
    }
    fitting
      .call(["formula", states.now.model, text])
      .then(({ found }) => {
        if (text === byId("expression").value.trim()) byId("formula_error").textContent = found.error || "";
      })
      .catch(() => {}); // cancelled with a change
  };
  byId("formula").onsubmit = (event) => {
    event.preventDefault();
    const text = byId("expression").value.trim();
    if (text) fit(({ expressions }) => ({ expressions: [...expressions, text] }));
  };

  // Takes the steps of an address; see remember().
  const replay = async (hash) => {
    let kept;
    try {
      kept = JSON.parse(decodeURIComponent(hash.slice(1)));
    } catch {
      throw new Error("The steps in this page's address are damaged: it begins anew.");
    }
    for (const [words, masks, holdouts] of kept.steps) {
      const end = words.findIndex((word) => word.startsWith("-"));
      const runs = words[0] === "fit" ? words.slice(1, end) : states.now.runs;
      const { answer, state } = await made_by(words, { masks, runs, holdouts });
      if (!state) throw new Error(answer.reason);
      states.push(state);
    }
    states.go(kept.at);
  };

  // Begins with the models that the page was written with.
  const begin_with_states = async () => {
    const masks = masks_from(setup.masks, files_of(setup));
    for (const { model, label, words, judgement, accepted } of setup.states) {
      const state = { model, masks, runs: setup.runs, holdouts: setup.holdouts, given: true };
      state.words = words.length ? words : null;
      state.label = label === model ? base_name(model) : label;
      state.judged = judgement ? { good: accepted, reason: judgement } : undefined;
      state.view = await view_of(state);
      states.push(state);
    }
    if (!states.now) return;
    // Without a fit so far: the engine reads the recordings for one now, not when the user asks for it.
    const first = fit_words(states.now, ["bias"], [], "first.model", rows_of(states.now.view));
    fitting.call(first).catch(() => {});
  };

  const begin = async (module, files) => {
    fitting = new Engine(module, new Map(files), working, trouble);
    diagnosing = new Engine(module, new Map(files), diagnosed_by, trouble);
    previewing = new Engine(module, new Map(files), () => {}, trouble);
    catalogue = checked(await fitting.call(["effects"])).effects;
    byId("opening").hidden = true;
    byId("starting").hidden = true;
    byId("bench").hidden = false;
    byId("link").disabled = false;
    let wrong = "";
    await in_turn(async () => {
      await begin_with_states();
      const { hash } = location;
      if (hash.length > 1)
        await replay(hash).catch((fault) => {
          wrong = fault.message;
        });
      if (states.now) go(states.at);
    });
    if (!states.now) await fit(() => ({}));
    if (wrong) trouble(wrong);
    titles = (await drawings_of(states.now).catch(() => [])).map(({ title }) => title);
    show_runs(states.now);
    document.body.ondragover = (event) => event.preventDefault();
    document.body.ondrop = (event) => {
      event.preventDefault();
      add_recordings([...event.dataTransfer.files]);
    };
  };

  // The means over 1 s of a file, instead of the file.
  const averaged = async (engine, name) => {
    const { text, note } = checked(await engine.call(["means", name, ...setup.reading]));
    setup.notes = [...(setup.notes || []), note];
    return new TextEncoder().encode(text);
  };

  // Fits to further recordings, too.
  const add_recordings = (chosen) =>
    in_turn(async () => {
      for (const file of chosen) {
        const { name } = file;
        fitting.put(name, file);
        const { large } = checked(await fitting.call(["columns", name, ...setup.reading]));
        const bytes = large ? await averaged(fitting, name) : new Uint8Array(await file.arrayBuffer());
        [fitting, diagnosing, previewing].forEach((engine) => engine.put(name, bytes));
        checked(await fitting.call(["info", name, ...setup.reading]));
      }
      const names = chosen.map(({ name }) => name);
      fit(({ runs, holdouts }) => ({
        runs: [...runs, ...names.filter((name) => ![...runs, ...holdouts].includes(name))],
      }));
    });
  byId("more").onchange = () => add_recordings([...byId("more").files]);

  // Asks for recordings, where the page has none.
  const ask_for_files = (module) => {
    const form = byId("opening");
    const files = new Map();
    const holdouts = new Set();
    byId("starting").hidden = true;
    form.hidden = false;
    const engine = new Engine(module, files, working, trouble);
    const look_at = (name) => async (map) =>
      checked(await engine.call(["columns", name, ...with_columns(words_of(byId("reading").value), map)]));
    const choose_columns = async (name) => {
      const map = await ask_for_columns(name, look_at(name), columns_in(words_of(byId("reading").value)));
      if (map === null) return;
      byId("reading").value = with_columns(words_of(byId("reading").value), map)
        .map(shell_word)
        .join(" ");
      await list();
    };
    // A large file is read once: when the bench begins.
    const large = new Set();
    const look_into = async (name, file) => {
      const { found: head } = await engine.call(["columns", name, ...setup.reading]);
      if (head.large && !head.error && !head.refusal) {
        large.add(name);
        return { ...head, size: `${Math.round(file.size / 1e6)} MB: the bench will have its means over 1 s` };
      }
      const { found } = await engine.call(["info", name, ...setup.reading]);
      return { ...found, size: `${found.rows} samples, every ${significant(found.period_s)} s` };
    };
    const list = async () => {
      setup.reading = words_of(byId("reading").value);
      const rows = [];
      let good = files.size > holdouts.size;
      large.clear();
      for (const [name, file] of files) {
        const found = await look_into(name, file);
        if (found.error) good = false;
        const use = make(
          "select",
          {
            ariaLabel: `use of ${name}`,
            onchange: () => {
              if (use.value === "holdout") holdouts.add(name);
              else holdouts.delete(name);
              list();
            },
          },
          make("option", { value: "fit", textContent: "fit to it" }),
          make("option", { value: "holdout", textContent: "holdout: judge by it", selected: holdouts.has(name) }),
        );
        const choose = make("button", {
          type: "button",
          textContent: "Columns …",
          ariaLabel: `columns of ${name}`,
          onclick: () => choose_columns(name),
        });
        const remove = make("button", {
          type: "button",
          textContent: "Remove",
          ariaLabel: `remove ${name}`,
          onclick: () => {
            engine.remove(name);
            holdouts.delete(name);
            list();
          },
        });
        rows.push(
          make(
            "li",
            {},
            make("strong", { textContent: name }),
            make("span", {}, choose, " ", use, " ", remove),
            ...(found.error ? [found.error] : [found.size, ...found.remarks]).map((line) =>
              make("p", { textContent: line }),
            ),
          ),
        );
      }
      byId("dropped").replaceChildren(...rows);
      byId("begin").disabled = !good;
    };
    // Takes files; opens the dialog for those whose columns are not clear.
    const take = async (chosen) => {
      for (const file of chosen) engine.put(file.name, file);
      await list();
      for (const { name } of chosen) {
        const { found } = await engine.call(["columns", name, ...setup.reading]);
        if (found.refusal && found.columns.length > 1 && found.rows.length > 0) await choose_columns(name);
      }
    };
    byId("chosen").onchange = () => take([...byId("chosen").files]);
    byId("reading").onchange = list;
    document.body.ondragover = (event) => {
      event.preventDefault();
      form.classList.add("over");
    };
    document.body.ondragleave = () => form.classList.remove("over");
    document.body.ondrop = (event) => {
      event.preventDefault();
      form.classList.remove("over");
      if (!form.hidden) take([...event.dataTransfer.files]);
    };
    form.onsubmit = async (event) => {
      event.preventDefault();
      setup.runs = [...files.keys()].filter((name) => !holdouts.has(name));
      setup.holdouts = [...holdouts];
      byId("begin").disabled = true;
      try {
        for (const [name, file] of files)
          files.set(name, large.size > 0 ? await averaged(engine, name) : new Uint8Array(await file.arrayBuffer()));
        if (large.size > 0) setup.reading = []; // of the files, not of their means
        trouble("");
        await begin(module, files);
      } catch (fault) {
        trouble(fault.message);
        await list();
      }
    };
  };

  const start = async () => {
    try {
      byId("starting").hidden = false;
      const module = await compile_engine();
      const files = [...document.querySelectorAll("script[data-file]")].map((script) => [
        script.dataset.file,
        bytes_of(script.textContent),
      ]);
      if (setup.runs.length > 0) await begin(module, files);
      else ask_for_files(module);
    } catch (fault) {
      byId("starting").hidden = true;
      trouble(`This page cannot calculate here: ${fault.message}. Open it in a browser of 2023 or later.`);
    }
  };

  // A report opens with its findings; the engine starts when the user turns to the workbench.
  let started = null;
  const show_view = (bench) => {
    document.body.dataset.view = bench ? "bench" : "report";
    byId("show_report").ariaPressed = String(!bench);
    byId("show_bench").ariaPressed = String(bench);
    if (bench) started = started || start();
  };
  byId("show_report").onclick = () => show_view(false);
  byId("show_bench").onclick = () => show_view(true);
  const has_report = Boolean(byId("report"));
  byId("views").hidden = !has_report;
  show_view(!has_report || location.hash.length > 1);
})();
