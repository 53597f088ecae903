// The page's behaviour: a change becomes a command, the command a state; the state is shown and then
// diagnosed in the background.
"use strict";
(async () => {
  let fitting = null; // engine of the user's changes
  let diagnosing = null; // engine of the diagnosis, which takes longer
  let previewing = null; // engine of the preview of the candidate under the mouse
  let catalogue = [];
  let run = 0;
  let variable = "temperature_degc";
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
  ];

  // Shows an error, or hides the last one.
  const trouble = (what) => {
    byId("trouble").textContent = what || "";
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

  // What is shown of a model: its comparison with the runs, and their columns.
  const view_of = async (model, masks) => {
    const inputs = setup.columns || [];
    const view = checked(await fitting.call(compare_words(model, masks), [...columns, ...inputs]));
    // Optional columns are known only after the first answer: asks again with them.
    const more = view.runs
      .flatMap((one) => one.variables.map(({ name }) => name))
      .filter((name) => ![...columns, ...inputs].includes(name));
    if (more.length === 0) return view;
    setup.columns = [...inputs, ...new Set(more)];
    return view_of(model, masks);
  };

  // Waits for a pause of the user; a change that is being fitted comes first. Of several calls in this
  // time the last one counts.
  let asked = 0;
  const diagnose = async (state) => {
    const turn = ++asked;
    diagnosing.cancel();
    await new Promise((done) => setTimeout(done, 300));
    if (turn !== asked || states.now !== state || changing > 0) return;
    try {
      state.diagnosis = checked(await diagnosing.call(diagnose_words(state.model, state.masks)));
    } catch (fault) {
      if (fault instanceof Cancelled) return;
      state.trouble = fault.message;
    }
    if (states.now === state) show_findings();
  };

  const show_findings = () => {
    const state = states.now;
    show_effects(catalogue, state.view, state.notes || [], state.diagnosis && state.diagnosis.diagnosis, actions);
    show_diagnosis(state, actions);
    document.body.dataset.diagnosed = state.diagnosis ? "yes" : "no";
  };

  const show_runs = (view) => {
    const group = byId("runs");
    group.hidden = view.runs.length < 2;
    group.replaceChildren(
      ...view.runs.map(({ file }, i) =>
        make("button", {
          type: "button",
          textContent: base_name(file) + (setup.holdouts.includes(file) ? " (holdout)" : ""),
          ariaPressed: String(i === run),
          onclick: () => {
            run = i;
            show();
          },
        }),
      ),
    );
    byId("variable").replaceChildren(
      ...view.runs[run].variables.map(({ name, label }) =>
        make("option", { value: name, textContent: label, selected: name === variable }),
      ),
    );
  };

  const show = () => {
    const { view } = states.now;
    run = Math.min(run, view.runs.length - 1);
    show_runs(view);
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
        .join("\n") || `$ ${shell_line(compare_words(states.now.model, states.now.masks))}`;
    show_masks();
    const notes = [...(setup.notes || []), ...(states.now.notes || [])];
    byId("notes").replaceChildren(...notes.map((note) => make("li", { textContent: note })));
    byId("notes_box").hidden = notes.length === 0;
    byId("undo").disabled = states.at <= 0;
    byId("redo").disabled = states.at >= states.list.length - 1;
    document.body.dataset.state = states.at;
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
    show();
  };

  // Fits a changed model: `change` returns what it changes of { effects, expressions, masks }.
  const fit = (label, change) =>
    in_turn(async () => {
      const model = states.next_model();
      const before = states.now
        ? {
            effects: effects_of(states.now.view),
            expressions: expressions_of(states.now.view),
            masks: states.now.masks,
          }
        : { effects: ["bias"], expressions: [], masks: masks_from(setup.masks) };
      const { effects, expressions, masks } = { ...before, ...change(before) };
      const words = fit_words(effects, expressions, model, masks, states.now ? rows_of(states.now.view) : []);
      const fitted = checked(await fitting.call(words));
      const same =
        states.now &&
        masks === before.masks &&
        String(words_of_terms(fitted)) === String(words_of_terms(states.now.view));
      if (fitted.no_step && same) throw new Error(fitted.no_step);
      keep_model(model, fitted.text);
      enter({
        model,
        words,
        label,
        masks,
        notes: [...fitted.remarks, fitted.no_step, ...steps_of(fitted)].filter(Boolean),
        view: await view_of(model, masks),
      });
    });

  // Adds effects or an expression if `add` accepts them out of sample; `force`: in any case.
  const judge = (what, force = false) =>
    in_turn(async () => {
      const model = states.next_model();
      const masks = states.now.masks;
      const words = [...add_words(states.now.model, what, model, masks), ...(force ? ["--force"] : [])];
      const answer = checked(await fitting.call(words));
      if (!answer.add.model) {
        states.now.judged = { good: false, reason: `Not added. ${answer.reason}`, anyway: () => judge(what, true) };
        show_findings();
        return;
      }
      keep_model(model, answer.text);
      enter({
        model,
        words,
        label: `+ ${answer.add.effects.join(", ")}`,
        masks,
        judged: { good: answer.add.accepted, reason: answer.reason },
        notes: [...answer.remarks, ...steps_of(answer)],
        view: await view_of(model, masks),
      });
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
    await new Promise((done) => setTimeout(done, 150));
    if (wanted !== effect || changing > 0) return;
    state.previews = state.previews || new Map();
    if (!state.previews.has(effect)) {
      previewing.cancel();
      const words = add_words(state.model, { effects: [effect] }, "preview.model", state.masks, "preview");
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

  const actions = {
    add: (effect) => fit(`+ ${effect}`, ({ effects }) => ({ effects: [...effects, effect] })),
    remove: (term) =>
      fit(`− ${term.effect}`, ({ effects, expressions }) => ({
        effects: effects.filter((words) => effect_name(words) !== term.effect),
        expressions: expressions.filter((words) => words !== term.words),
      })),
    change: (changed) =>
      fit(changed, ({ effects }) => ({
        effects: effects.map((words) => (effect_name(words) === effect_name(changed) ? changed : words)),
      })),
    judge,
    preview,
  };

  // Draws the shown run with its masks.
  const draw = () => {
    const name = name_of_run();
    const masks = states.now.masks.filter(([of]) => of === name).map(([, from, to]) => [from, to]);
    draw_run(states.now.view, run, variable, masks, masking() ? select_mask : null);
  };
  const name_of_run = () => states.now.view.runs[run].file;
  const masking = () => byId("mask_mode").ariaPressed === "true";
  const mask = (from, to) =>
    fit(`mask ${from}..${to} s`, ({ masks }) => ({ masks: [...masks, [name_of_run(), from, to]] }));
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
            title: "Remove this mask",
            ariaLabel: `remove the mask ${base_name(one[0])} ${one[1]} to ${one[2]} s`,
            textContent: `${base_name(one[0])} ${one[1]}..${one[2]} s ×`,
            onclick: () =>
              fit(`unmask ${one[1]}..${one[2]} s`, ({ masks }) => ({ masks: masks.filter((other) => other !== one) })),
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
    variable = byId("variable").value;
    draw_variable(states.now.view, run, variable);
  };
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
  byId("link").onclick = () =>
    copy(location.href.split("#")[0] + "#" + encodeURIComponent(JSON.stringify(states.commands())), byId("link"));
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
    if (text) fit(`+ ${text}`, ({ expressions }) => ({ expressions: [...expressions, text] }));
  };

  // Runs the commands of a link.
  const replay = async (commands) => {
    for (const words of commands) {
      const model = words[words.indexOf("-o") + 1];
      const answer = checked(await fitting.call(words));
      if (!answer.text) throw new Error(answer.reason);
      keep_model(model, answer.text);
      states.reserve(model);
      const masks = masks_from(words);
      states.push({
        model,
        words,
        masks,
        label: words[0] === "fit" ? words[words.indexOf("--effects") + 1] : `+ ${answer.add.effects.join(", ")}`,
        view: await view_of(model, masks),
      });
    }
    go(states.list.length - 1);
  };

  // Shows the models that the page was written with.
  const begin_with_states = async () => {
    const masks = masks_from(setup.masks);
    for (const { model, label, words, judgement, accepted } of setup.states) {
      states.push({
        model,
        masks,
        label: label === model ? base_name(model) : label,
        words: words.length ? words : null,
        view: await view_of(model, masks),
        judged: judgement ? { good: accepted, reason: judgement } : undefined,
      });
    }
    if (setup.states.length === 0) return;
    go(states.list.length - 1);
    // Without a fit so far: the engine reads the recordings for one now, not when the user asks for it.
    const first = fit_words(["bias"], [], "first.model", masks, rows_of(states.now.view));
    fitting.call(first).catch(() => {});
  };

  const begin = async (module, files) => {
    fitting = new Engine(module, new Map(files), working, trouble);
    diagnosing = new Engine(module, new Map(files), () => {}, trouble);
    previewing = new Engine(module, new Map(files), () => {}, trouble);
    catalogue = checked(await fitting.call(["effects"])).effects;
    byId("opening").hidden = true;
    byId("starting").hidden = true;
    byId("bench").hidden = false;
    byId("link").disabled = false;
    await in_turn(async () => {
      if (location.hash.length > 1) return replay(JSON.parse(decodeURIComponent(location.hash.slice(1))));
      await begin_with_states();
    });
    if (!states.now) await fit("bias", () => ({}));
  };

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
    const list = async () => {
      setup.reading = words_of(byId("reading").value);
      const rows = [];
      let good = files.size > holdouts.size;
      for (const name of files.keys()) {
        const { found } = await engine.call(["info", name, ...setup.reading]);
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
        rows.push(
          make(
            "li",
            {},
            make("strong", { textContent: name }),
            make("span", {}, choose, " ", use),
            ...(found.error
              ? [found.error]
              : [`${found.rows} samples, every ${significant(found.period_s)} s`, ...found.remarks]
            ).map((line) => make("p", { textContent: line })),
          ),
        );
      }
      byId("dropped").replaceChildren(...rows);
      byId("begin").disabled = !good;
    };
    // Takes files; opens the dialog for those whose columns are not clear.
    const take = async (chosen) => {
      for (const file of chosen) engine.put(file.name, new Uint8Array(await file.arrayBuffer()));
      await list();
      for (const { name } of chosen) {
        const { found } = await engine.call(["columns", name, ...setup.reading]);
        if (found.refusal && found.columns.length > 1) await choose_columns(name);
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
    form.onsubmit = (event) => {
      event.preventDefault();
      setup.runs = [...files.keys()].filter((name) => !holdouts.has(name));
      setup.holdouts = [...holdouts];
      begin(module, files);
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
