// node workbench.mjs DRIVER SHOTS work|files|PART: what workbench.sh says, on its pages in this folder. Work leaves the
// page's first diagnosis, that of two runs, the commands of a random session and the model that the page made of it.
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { trapping, with_memory } from "./altered_module.mjs";
import { address_of, drag, launch, new_page, open, settle, show, until } from "./browser.mjs";

const [driver, shots, only] = process.argv.slice(2);
let failures = 0;
const check = (name, good, what) => {
  if (good) return;
  ++failures;
  console.error(`${name}: ${what}`);
};
const picture = async (page, name) => {
  if (shots) await page.screenshot({ path: join(shots, `${name}.png`), fullPage: true });
};

// A page with the actions of a user.
class Bench {
  static async open(browser, name, first = "") {
    const bench = new Bench();
    bench.name = name;
    bench.page = await new_page(browser);
    // Tests record the workers and what is saved or copied.
    await bench.page.evaluateOnNewDocument(
      first +
        `
      window.workers = [];
      window.Worker = class extends Worker { constructor(...all) { super(...all); workers.push(this); } };
      const address_of = URL.createObjectURL;
      URL.createObjectURL = (blob) => { if (blob.type === "") window.saved = blob; return address_of(blob); };
      if (navigator.clipboard) navigator.clipboard.writeText = async (text) => { window.copied = text; };`,
    );
    await show(bench.page, { width: 1280, dark: false });
    await open(bench.page, name);
    return bench;
  }

  until(expression) {
    return until(this.page, expression);
  }
  state(index) {
    return this.until(`document.body.dataset.state === "${index}"`);
  }
  diagnosed() {
    return this.until(`document.body.dataset.diagnosed === "yes"`);
  }
  text(selector) {
    return this.page.evaluate(`document.querySelector(${JSON.stringify(selector)})?.textContent ?? ""`);
  }

  // A place on an element, brought into view: `share` of its width.
  async place(selector, share = 0.5) {
    const { left, top, width, height } = await this.page.$eval(selector, (element) => {
      element.scrollIntoView({ block: "center" });
      return element.getBoundingClientRect().toJSON();
    });
    return { x: left + share * width, y: top + height / 2 };
  }
  async hover(selector) {
    const { x, y } = await this.place(selector);
    await this.page.mouse.move(x, y);
  }
  async click(selector) {
    const { x, y } = await this.place(selector);
    await this.page.mouse.click(x, y);
  }
  // `meanwhile`: what happens before the button is let go.
  async drag(selector, from, to, meanwhile) {
    await drag(this.page, await this.place(selector, from), await this.place(selector, to), meanwhile);
  }
  key(name) {
    return this.page.keyboard.press(name);
  }
  async undo() {
    await this.page.keyboard.down("Control");
    await this.key("z");
    await this.page.keyboard.up("Control");
  }

  async write(selector, text) {
    await this.click(selector);
    await this.page.keyboard.sendCharacter(text);
  }
  async choose_file(file) {
    await (await this.page.$("#chosen")).uploadFile(file);
  }
  async save(button) {
    await this.page.evaluate("window.saved = null");
    await this.click(button);
    await this.until("window.saved");
    return this.page.evaluate("window.saved.text()");
  }

  // The accessibility tree: every control has a name, and contents that change by themselves are announced.
  async listen(label, { announced = [] } = {}) {
    const protocol = await this.page.createCDPSession(); // puppeteer's own tree does not say what is announced
    const { nodes } = await protocol.send("Accessibility.getFullAXTree");
    await protocol.detach();
    const seen = nodes.filter((node) => !node.ignored);
    const operated = [
      "button",
      "checkbox",
      "textbox",
      "combobox",
      "slider",
      "link",
      "radio",
      "spinbutton",
      "DisclosureTriangle",
      "dialog",
      "img",
      "toolbar",
      "group",
      "region",
    ];
    const role = (node) => node.role?.value;
    const nameless = seen.filter(
      (node) =>
        operated.includes(role(node)) &&
        !(node.name?.value || "").trim() &&
        (role(node) !== "group" || (node.properties || []).some(({ name }) => name === "focusable")),
    );
    check(label, nameless.length === 0, `without a name: ${nameless.map(role)}`);
    check(label, seen.filter((node) => role(node) === "button").length > 1, "hardly anything to operate");
    check(
      label,
      seen.some((node) => role(node) === "heading"),
      "no heading",
    );
    const live = seen
      .filter((node) => (node.properties || []).some(({ name, value }) => name === "live" && value.value !== "off"))
      .map((node) => role(node));
    announced.forEach((one) =>
      check(label, live.includes(one), `nothing of the role ${one} is announced, but ${live}`),
    );
  }

  // The error of the state that is shown, from the ladder.
  async error() {
    return Number(await this.text("#ladder [aria-current] .value"));
  }

  // Checks brightness, width, names and curves at 1280 and 390 px, light and dark.
  async look(label) {
    for (const width of [1280, 390]) {
      for (const dark of [false, true]) {
        await show(this.page, { width, dark });
        await this.page.evaluate("scrollTo(0, 0)");
        const seen = await this.page.evaluate(`(() => {
          const [r, g, b] = getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number);
          const named = (element) =>
            element.ariaLabel || element.labels?.[0]?.textContent.trim() || element.textContent.trim();
          return {
            paper: (r + g + b) / 3, sideways: document.documentElement.scrollWidth - innerWidth,
            nameless: [...document.querySelectorAll("button, input, select")]
              .filter((element) => element.checkVisibility() && !named(element)).length,
            coloured: [...document.querySelectorAll("#bench canvas")].map((canvas) => {
              const { width, height } = canvas;
              const copy = Object.assign(document.createElement("canvas"), { width, height });
              const pen = copy.getContext("2d", { willReadFrequently: true });
              pen.drawImage(canvas, 0, 0);
              const pixels = pen.getImageData(0, 0, copy.width, copy.height).data;
              let count = 0;
              for (let i = 0; i < pixels.length; i += 4) {
                const rgb = [pixels[i], pixels[i + 1], pixels[i + 2]];
                if (pixels[i + 3] > 60 && Math.max(...rgb) - Math.min(...rgb) > 60) ++count;
              }
              return count;
            }),
          };
        })()`);
        const view = `${this.name}, ${width} px, ${dark ? "dark" : "light"}`;
        check(view, dark ? seen.paper < 60 : seen.paper > 230, `paper of brightness ${seen.paper}`);
        check(view, seen.sideways <= 0, `is ${seen.sideways} px wider than the window`);
        check(view, seen.nameless === 0, `${seen.nameless} controls have no name`);
        check(
          view,
          seen.coloured.length === 3 && seen.coloured.every((count) => count > 40),
          `coloured pixels: ${seen.coloured}`,
        );
        await picture(this.page, `${label}_${width}_${dark ? "dark" : "light"}`);
      }
    }
    await show(this.page, { width: 1280, dark: false });
  }
  silent() {
    check(this.name, this.page.complaints.length === 0, `the console says: ${this.page.complaints.join("; ")}`);
    const others = this.page.requests.filter(
      (request) => !request.startsWith("file://") && !request.startsWith("blob:"),
    );
    check(this.name, others.length === 0, `asks for ${others.join(", ")}`);
    const files = this.page.requests.filter((request) => request.startsWith("file://"));
    check(this.name, new Set(files.map((one) => one.split("#")[0])).size === 1, `reads ${files.join(", ")}`);
  }
}

// The README's loop: compare, diagnose, add what is missing, the error falls; then undo, masks, a refusal, a formula.
const loop = async (browser) => {
  const bench = await Bench.open(browser, "loop.html");
  await bench.state(0);
  check(
    "loop",
    (await bench.text("#found")).startsWith("Residual 852.3 °/h against a floor of 9.679"),
    await bench.text("#found"),
  );
  await bench.diagnosed();
  check(
    "loop",
    /missing.*: thermal_lag/i.test(await bench.text("#diagnosis .verdict")),
    await bench.text("#diagnosis"),
  );
  const diagnosis = await bench.page.evaluate("JSON.stringify(states.now.diagnosis.diagnosis, null, 1)");
  writeFileSync("page_diagnosis.json", diagnosis);
  await bench.look("before");
  await bench.listen("loop", { announced: ["status"] });
  await bench.hover("#candidates tbody tr");
  await bench.until(`document.getElementById("candidate").textContent.startsWith("with ")`);
  await picture(bench.page, "candidate");
  const before = await bench.error();
  // An effect that was ticked and does not help is judged, and taken out by Ctrl+Z.
  await bench.click("#effect_aging");
  await bench.state(1);
  await bench.until(`document.querySelector(".judged")`);
  check("loop", !(await bench.page.$(".judged.good")), `aging helps: ${await bench.text(".judged")}`);
  await bench.undo();
  await bench.state(0);
  await bench.diagnosed();
  await bench.click("#add_missing");
  await bench.state(1);
  const errors = [before, await bench.error()];
  for (const state of [2, 3]) {
    await bench.diagnosed();
    await bench.click("#add_missing");
    await bench.state(state);
    errors.push(await bench.error());
  }
  const falls = errors.every((error, i) => i === 0 || error < errors[i - 1]);
  check("loop", falls && errors[3] < before / 5, `adding what is missing leaves ${errors}`);
  check("loop", await bench.page.$(".judged.good"), `what is missing is refused: ${await bench.text(".judged")}`);
  await bench.diagnosed();
  await bench.look("after");
  await bench.undo();
  await bench.state(2);
  check("loop", (await bench.error()) === errors[2], "Ctrl+Z does not undo");
  await bench.click("#redo");
  await bench.state(3);
  // Rows are masked by a drag, listed, and counted again.
  await bench.click("#mask_mode");
  await bench.drag("#residual_plot .u-over", 0.2, 0.3);
  await bench.state(4);
  check("loop", /mems.csv \d+\.\.\d+ s/.test(await bench.text("#masks")), "masked rows are not listed");
  check("loop", /--mask \d+\.\.\d+/.test(await bench.text("#commands")), "the mask is in no command");
  await bench.click("#masks button[title='Remove this mask']");
  await bench.state(5);
  check("loop", !/\d+\.\.\d+ s/.test(await bench.text("#masks")), "a mask cannot be taken away");
  await bench.diagnosed();
  // A formula says what is wrong with it as it is typed.
  await bench.click("#expression");
  await bench.page.keyboard.sendCharacter("x = T*T*");
  await bench.until(`/column 9/.test(document.getElementById("formula_error").textContent)`);
  bench.silent();
};

// Figures of two runs are pooled: leaves their diagnosis.
const two_runs = async (browser) => {
  const bench = await Bench.open(browser, "two_runs.html");
  await bench.state(0);
  await bench.diagnosed();
  const diagnosis = await bench.page.evaluate("JSON.stringify(states.now.diagnosis.diagnosis, null, 1)");
  writeFileSync("page_two_runs.json", diagnosis);
  bench.silent();
};

// With the keyboard alone: a few presses of Tab come to what is to be added, Enter adds it, the focus stays there; Space
// ticks an effect of the catalogue.
const keyboard = async (browser) => {
  const bench = await Bench.open(browser, "loop.html");
  await bench.state(0);
  await bench.diagnosed();
  const focus = () => bench.page.evaluate("document.activeElement.id");
  const tab_to = async (id, most) => {
    let presses = 0;
    for (; presses < most && (await focus()) !== id; ++presses) await bench.key("Tab");
    check("keyboard", (await focus()) === id, `${presses} presses of Tab do not come to ${id} but to ${await focus()}`);
  };
  await tab_to("add_missing", 10);
  await bench.key("Enter");
  await bench.state(1);
  await bench.diagnosed();
  check(
    "keyboard",
    await bench.page.evaluate(`byId("diagnosis").contains(document.activeElement)`),
    `the focus falls to ${await focus()}`,
  );
  await tab_to("effect_temperature_rate", 70);
  await bench.key("Space");
  await bench.state(2);
  check(
    "keyboard",
    await bench.page.evaluate(`document.getElementById("effect_temperature_rate").checked`),
    "Space does not tick",
  );
  bench.silent();
};

// A reload keeps the steps, and an address that is damaged is said to be.
const reload = async (browser) => {
  const bench = await Bench.open(browser, "loop.html");
  await bench.state(0);
  await bench.click("#effect_thermal_lag");
  await bench.state(1);
  await bench.click("#effect_temperature_rate");
  await bench.state(2);
  await bench.undo();
  await bench.state(1);
  const error = await bench.error();
  await bench.page.reload();
  await bench.state(1);
  check("reload", (await bench.error()) === error, `leaves ${await bench.error()}, not ${error}`);
  check("reload", (await bench.page.$$("#ladder button")).length === 3, `the ladder is ${await bench.text("#ladder")}`);
  await bench.click("#redo");
  await bench.state(2);
  await bench.page.goto(address_of("loop.html") + "#garbage");
  await bench.page.reload();
  await bench.state(0);
  await bench.until(`/damaged/.test(document.getElementById("trouble").textContent)`);
  bench.silent();
};

// Chooses an option as a user does.
const choose = (bench, selector, value) =>
  bench.page.evaluate(`(() => {
    const select = document.querySelector(${JSON.stringify(selector)});
    select.value = ${JSON.stringify(value)};
    select.dispatchEvent(new Event("change"));
  })()`);

// A recording becomes a holdout, is left out, and comes again, each a step that is undone.
const recordings = async (browser) => {
  const bench = await Bench.open(browser, "two_runs.html");
  await bench.state(0);
  await bench.diagnosed(); // nothing moves any more under the mouse
  await bench.click("#runs button:nth-child(2)");
  await choose(bench, "#run_use", "holdout");
  await bench.state(1);
  check("recordings", /other.csv \(holdout\)/.test(await bench.text("#runs")), await bench.text("#runs"));
  check("recordings", /on holdouts/.test(await bench.text("#ladder")), "no bar of the holdout");
  await choose(bench, "#run_use", "remove");
  await bench.state(2);
  check("recordings", !/other.csv/.test(await bench.text("#runs")), "a recording cannot be left out");
  check(
    "recordings",
    await bench.page.evaluate(`document.getElementById("run_use").disabled`),
    "the last recording can be left out",
  );
  await (await bench.page.$("#more")).uploadFile("other.csv");
  await bench.state(3);
  check("recordings", /fit run.csv other.csv /.test(await bench.text("#commands")), await bench.text("#commands"));
  await bench.undo();
  await bench.state(2);
  await bench.undo();
  await bench.state(1);
  check("recordings", /other.csv \(holdout\)/.test(await bench.text("#runs")), "an undo leaves the recordings");
  await (await bench.page.$("#more")).uploadFile("no_recording.csv");
  await bench.until(`!document.getElementById("trouble").hidden`);
  check("recordings", /no_recording/.test(await bench.text("#trouble")), await bench.text("#trouble"));
  check("recordings", await bench.page.evaluate(`document.body.dataset.state === "1"`), "an unreadable file is a step");
  bench.silent();
};

// Values under the cursor, a row masked by a click, axes of the third plot and drawings of the residual, each beside the
// step before.
const looking = async (browser) => {
  const bench = await Bench.open(browser, "session.html");
  await bench.state(0);
  await bench.diagnosed();
  const [shown, varies] = await bench.page.evaluate(
    `[document.getElementById("variable").value, states.now.diagnosis.diagnosis.where.variable]`,
  );
  check("looking", shown === varies, `opens on ${shown}, though it varies most with ${varies}`);
  await bench.click("#effect_temperature_rate");
  await bench.state(1);
  for (const plot of ["rate", "residual", "variable"]) {
    await bench.hover(`#${plot}_plot .u-over`);
    await bench.until(
      `/ h, .*°C.*residual -?[0-9.e-]+ °\\/h/.test(document.getElementById("${plot}_read").textContent)`,
    );
  }
  const picture_of = (id) => bench.page.evaluate(`document.querySelector("#${id} canvas").toDataURL()`);
  const alone = await picture_of("residual_plot");
  await bench.click("#show_before");
  await settle(bench.page);
  check("looking", (await picture_of("residual_plot")) !== alone, "the step before is not drawn");
  await picture(bench.page, "before_and_after");
  await bench.click("#show_before");
  const usual = await picture_of("variable_plot");
  await choose(bench, "#quantity", "temperature_degc");
  await choose(bench, "#variable", "time_s");
  await settle(bench.page);
  check("looking", (await picture_of("variable_plot")) !== usual, "the y axis is not chosen");
  await choose(bench, "#variable", "temperature_degc x temperature_rate");
  await settle(bench.page);
  const titles = await bench.page.evaluate(
    `[...document.querySelectorAll("#variable optgroup:nth-child(2) option")].map((option) => option.value)`,
  );
  for (const wanted of [
    /band/,
    /Allan deviation in soaks/,
    /Allan deviation of the whole/,
    /Spectrum/,
    /Distribution/,
    /normal/,
    /correlation/,
  ])
    check(
      "looking",
      titles.some((title) => wanted.test(title)),
      `no drawing of ${wanted} in ${titles}`,
    );
  for (const title of titles) {
    await choose(bench, "#variable", title);
    await bench.until(
      `document.querySelector("#drawing canvas") && document.getElementById("drawing_caption").textContent`,
    );
    const legend = await bench.text("#drawing .u-legend");
    check("looking", !/\.model/.test(legend), `${title} names files: ${legend}`);
    if (/Spectrum/.test(title)) check("looking", /before.*step before.*this step/.test(legend), `${title}: ${legend}`);
    await picture(bench.page, `drawing_${title.replace(/\W+/g, "_").slice(0, 24)}`);
  }
  await choose(bench, "#variable", "correlations of the parameters");
  await bench.until(`document.querySelectorAll("#matrix tbody tr").length === 2`);
  const matrix = await bench.page.evaluate(
    `[...document.querySelectorAll("#matrix tbody tr")].map((row) => row.textContent)`,
  );
  check("looking", /^2 temperature_rate K-?[01]\.\d\d$/.test(matrix[1]), `correlations: ${matrix}`);
  await picture(bench.page, "correlations");
  await bench.click("#mask_mode");
  await bench.click("#residual_plot .u-over");
  await bench.state(2);
  const [, from, to] = (await bench.text("#masks")).match(/(\d+)\.\.(\d+) s/);
  check("looking", to - from >= 10 && to - from <= 12, `a click masks ${from}..${to} s`);
  await bench.diagnosed();
  bench.silent();
};

// What is clicked is large enough; a diagnosis is stopped and asked for again; the page prints with its names and plots.
const handling = async (browser) => {
  const bench = await Bench.open(browser, "session.html");
  await bench.state(0);
  await bench.until(`document.getElementById("stop_diagnosis")`);
  await bench.click("#stop_diagnosis");
  await bench.until(`/^Not diagnosed/.test(document.getElementById("progress").textContent)`);
  await bench.click("#stop_diagnosis");
  await bench.until(
    `/\\d %/.test(document.getElementById("progress")?.textContent) || document.body.dataset.diagnosed === "yes"`,
  );
  await bench.diagnosed();
  const small = await bench.page
    .evaluate(`[...document.querySelectorAll("button, select, input, summary, label.button")]
    .filter((one) => one.checkVisibility() && one.type !== "file")
    .map((one) => [one, (one.type === "checkbox" ? one.closest("label") : one).getBoundingClientRect()])
    .filter(([, { width, height }]) => width < 24 || height < 24)
    .map(([one, { width, height }]) => \`\${one.id || one.textContent || one.className} \${width} x \${height}\`)`);
  check("handling", small.length === 0, `smaller than 24 px: ${small}`);
  await bench.page.pdf({ timeout: 0, preferCSSPageSize: true, path: shots ? join(shots, "bench.pdf") : undefined });
  await bench.page.evaluate("dispatchEvent(new Event('beforeprint'))");
  await settle(bench.page);
  await picture(bench.page, "printed");
  const paper = await bench.page.evaluate(`(() => {
    const rect = (element) => element.getBoundingClientRect();
    const parts = ["middle", "left", "right"].map((id) => rect(byId(id)));
    return {
      names: [...document.querySelectorAll("#effects .name")].every((one) => one.checkVisibility() && rect(one).width > 20),
      forms: [...document.querySelectorAll("#bench form")].some((one) => one.checkVisibility()),
      wide: [...document.querySelectorAll("#bench canvas")].filter((one) => rect(one).right > 690).length,
      overlaid: parts.some((a, i) => parts.some((b, j) => i < j && a.top < b.bottom - 1 && b.top < a.bottom - 1)),
    };
  })()`);
  check("handling", paper.names, "the printed effects have no names");
  check("handling", !paper.forms, "forms are printed");
  check("handling", paper.wide === 0 && !paper.overlaid, `on paper: ${JSON.stringify(paper)}`);
  await bench.page.evaluate("dispatchEvent(new Event('afterprint'))");
  bench.silent();
};

// A random session with a real mouse: effects ticked, shapes dragged, fixed and freed, formulas and masks added. The
// commands that the page then shows are left for workbench.sh, which runs them in a shell.
const session = async (browser) => {
  const bench = await Bench.open(browser, "session.html");
  await bench.state(0);
  await bench.diagnosed();
  const effects = ["bias_temperature", "temperature_rate", "thermal_lag", "shupe", "thermal_hysteresis"];
  const formulas = ["burst = T*T*dTdt", "late = lag(T,?tau[60,900]) - T"];
  let draw = 20261123;
  const chance = (most) => {
    draw = (draw * 1103515245 + 12345) % 2147483648;
    return Math.floor((draw / 2147483648) * most);
  };
  const ripple = "#effects .shape input[aria-label='period of polarization_ripple']";
  const acts = {
    ripple: async () => {
      await bench.click("#effect_polarization_ripple");
      await bench.until(
        `document.querySelector("#effect_polarization_ripple").checked && document.body.dataset.state === "1"`,
      );
      await bench.page.evaluate(
        `document.getElementById("effect_polarization_ripple").closest("li").querySelector(".name").click()`,
      );
    },
    tick: () => bench.click(`#effect_${effects[chance(effects.length)]}`),
    drag: () => bench.drag(ripple, 0.5, 0.2 + 0.001 * chance(600)),
    free: () => bench.click(`${ripple} + button`), // fixed where it was free
    formula: async () => {
      await bench.write("#expression", formulas[chance(formulas.length)]);
      await bench.key("Enter");
    },
    mask: async () => {
      await bench.click("#mask_mode");
      await bench.drag("#residual_plot .u-over", 0.4, 0.45);
    },
  };
  const rest = ["tick", "tick", "drag", "free", "formula", "mask"];
  const order = [
    "ripple",
    "drag",
    ...rest
      .map((one) => [chance(1000), one])
      .sort((a, b) => a[0] - b[0])
      .map(([, one]) => one),
    "free",
  ];
  let step = 0;
  for (const act of order) {
    ++step;
    await acts[act]();
    await bench.until(`document.body.dataset.state === "${step}" || !document.getElementById("trouble").hidden`);
    check(
      "session",
      await bench.page.evaluate(`document.getElementById("trouble").hidden`),
      `${act}: ${await bench.text("#trouble")}`,
    );
  }
  await bench.diagnosed();
  if (await bench.page.evaluate(`Boolean(document.getElementById("add_missing"))`)) {
    await bench.click("#add_missing");
    await bench.until(`document.body.dataset.state === "${step + 1}" || document.querySelector(".judged")`);
  }
  for (const [button, file] of [
    ["#save_model", "page.model"],
    ["#save_header", "page.h"],
    ["#save_rows", "page.csv"],
    ["#save_report", "page.html"],
  ]) {
    writeFileSync(file, await bench.save(button));
  }
  await bench.click("#copy_commands");
  await bench.until("window.copied");
  writeFileSync("commands.txt", (await bench.page.evaluate("window.copied")) + "\n");
  const error = await bench.error();
  await bench.look("session");
  // The same state from its link.
  await bench.page.evaluate("window.copied = ''");
  await bench.click("#link");
  await bench.until("window.copied");
  const link = await bench.page.evaluate("window.copied");
  const at = await bench.page.evaluate("states.at");
  const again = new Bench();
  again.name = "link";
  again.page = await new_page(browser);
  await again.page.goto(link);
  await again.state(at);
  check("link", (await again.error()) === error, `leaves ${await again.error()}, not ${error}`);
  bench.silent();
};

// Names from files are never markup. An engine that traps is started again, and the page goes on.
const trouble = async (browser) => {
  const bench = await Bench.open(browser, "hostile.html");
  await bench.state(0);
  check(
    "hostile",
    await bench.page.evaluate(`document.querySelectorAll("img, main b").length === 0 && document.title !== "gone"`),
    "a name became markup",
  );
  check("hostile", (await bench.text("header .subject")).includes("<img src=x"), "the name is not shown as it is");
  // Replaces the engine's module by one that traps.
  const trap = trapping("hostile.html", "fogcomp_call");
  await bench.page.evaluate(`WebAssembly.compile(Uint8Array.from(atob("${trap}"), (letter) => letter.charCodeAt(0)))
    .then((module) => { workers[0].postMessage({ module }); })`);
  await bench.click("#effect_bias_temperature");
  await bench.until(`/engine stopped \\(unreachable\\)/.test(document.getElementById("trouble").textContent)`);
  await bench.listen("hostile", { announced: ["alert", "status"] });
  check("hostile", await bench.page.evaluate(`document.body.dataset.state === "0"`), "what was shown is lost");
  await bench.click("#effect_bias_temperature");
  await bench.state(1);
  check("hostile", await bench.page.evaluate(`document.getElementById("trouble").hidden`), "the page does not go on");
  bench.silent();
};

// A jump of the bias is named, cut at its time by a click, and listed beside the masks.
const stepped = async (browser) => {
  const bench = await Bench.open(browser, "stepped.html");
  await bench.until(`document.getElementById("add_missing")`);
  const label = await bench.page.evaluate(`document.getElementById("add_missing").textContent`);
  check("stepped", /^Let the bias begin anew at (259|260)\d\d s$/.test(label), label);
  await bench.click("#add_missing");
  await bench.state(1);
  const cuts = await bench.page.evaluate(`document.getElementById("masks").textContent`);
  check("stepped", /cut at (259|260)\d\d s/.test(cuts), cuts);
  bench.silent();
};

// A recording too large for the memory is refused, and the next one is read.
const memory = async (browser) => {
  const bench = await Bench.open(
    browser,
    "empty.html",
    `
    const bytes = Uint8Array.from(atob("${with_memory("empty.html", 290)}"), (letter) => letter.charCodeAt(0));
    const compile = WebAssembly.compile;
    WebAssembly.compile = () => compile(bytes);`,
  );
  await bench.until(`!document.getElementById("opening").hidden`);
  await bench.choose_file("fast.csv");
  await bench.until(`!document.getElementById("begin").disabled`);
  await bench.click("#begin");
  await bench.until(`/out of memory|engine stopped/.test(document.body.innerText)`);
  await bench.choose_file("mems.csv");
  await bench.until(`/8399 samples/.test(document.getElementById("dropped").textContent)`);
};

// Esc cancels a drag across a plot and one of a slider.
const escape = async (browser) => {
  const bench = await Bench.open(browser, "loop.html");
  await bench.state(0);
  await bench.diagnosed();
  await bench.click("#mask_mode");
  await bench.drag("#residual_plot .u-over", 0.2, 0.4, () => bench.key("Escape"));
  await bench.click("#effect_thermal_lag");
  await bench.state(1);
  check("escape", (await bench.text("#masks")) === "", "a drag that was cancelled masks");
  await bench.diagnosed();
  await bench.page.evaluate(
    `document.getElementById("effect_thermal_lag").closest("li").querySelector(".name").click()`,
  );
  const slider = "[aria-label='tau of thermal_lag']";
  const shape = () => bench.text(`.shape:has(${slider}) .figure`);
  const before = await shape();
  check("escape", /^tau \d/.test(before), `the shape is "${before}"`);
  await bench.drag(slider, 0.3, 0.8, () => bench.key("Escape"));
  await settle(bench.page);
  check("escape", (await shape()) === before, `a shape that was let go is ${await shape()}, not ${before}`);
  check(
    "escape",
    (await bench.page.evaluate("document.body.dataset.state")) === "1",
    "a slider that was cancelled refits",
  );
  const drawn = () => bench.page.evaluate("plots.residual.u.data[2].join()");
  const released = await drawn();
  await bench.drag(slider, 0.3, 0.8, async () => {
    await bench.until(`/^thermal_lag:tau=.* rms$/.test(document.getElementById("candidate").textContent)`);
    check("escape", (await drawn()) !== released, "a slider that is dragged does not show its fit");
    check(
      "escape",
      (await bench.page.evaluate("document.body.dataset.state")) === "1",
      "a slider that is held makes a step",
    );
  });
  await bench.state(2);
  check("escape", (await bench.text("#candidate")) === "", `says ${await bench.text("#candidate")}`);
  check("escape", (await bench.text("#commands")).includes("thermal_lag:tau="), "a drag does not fix the shape");
  await bench.listen("escape", { announced: ["status"] });
  bench.silent();
};

// A rate-table run: draws the residual over input rate and history, adds what is missing until nothing is.
const rate_table = async (browser) => {
  const bench = await Bench.open(browser, "table.html");
  await bench.state(0);
  await bench.diagnosed();
  const options = await bench.page.evaluate(
    `[...document.querySelectorAll("#variable option")].map((option) => option.textContent)`,
  );
  check(
    "table",
    options.includes("input rate, °/h") && options.some((text) => text.startsWith("history: ")),
    `axes: ${options}`,
  );
  for (const variable of ["input_rate", "play(T, 5 degC)"]) {
    await bench.page.evaluate(`(() => {
      const select = document.getElementById("variable");
      select.value = ${JSON.stringify(variable)};
      select.dispatchEvent(new Event("change"));
    })()`);
    await settle(bench.page);
    const axis = await bench.page.evaluate(
      `[document.getElementById("variable").value, document.querySelectorAll("#variable_plot canvas").length]`,
    );
    check("table", axis[0] === variable && axis[1] === 1, `the axis is ${axis}`);
    const range = await bench.page.evaluate(`plots.variable.u.data[0]`);
    check(
      "table",
      variable === "input_rate" || range.every((value) => Math.abs(value) < 5.001),
      `${variable} goes from ${range[0]} to ${range[1]}`,
    );
    await picture(bench.page, `over_${variable.replace(/\W+/g, "_")}`);
  }
  const before = await bench.error();
  let state = 0;
  for (; state < 6 && (await bench.page.evaluate(`Boolean(document.getElementById("add_missing"))`)); ++state) {
    await bench.click("#add_missing");
    await bench.state(state + 1);
    await bench.diagnosed();
  }
  const after = await bench.error();
  check("table", state > 0 && after < before / 3, `${state} additions leave ${after} of ${before}`);
  check("table", /scale_factor/.test(await bench.text("#commands")), `adds ${await bench.text("#commands")}`);
  check(
    "table",
    !(await bench.page.evaluate(`Boolean(document.getElementById("add_missing"))`)),
    "something is still missing",
  );
  await bench.look("table");
  bench.silent();
};

// A report opens with its findings; its workbench begins with the command's model. It can be read without scripts.
const report = async (browser) => {
  const bench = await Bench.open(browser, "report.html");
  check(
    "report",
    await bench.page.evaluate(
      `getComputedStyle(document.getElementById("workbench")).display === "none" && workers.length === 0`,
    ),
    "the engine starts unasked",
  );
  await bench.listen("report");
  await bench.click("#show_bench");
  await bench.state(1);
  check(
    "report",
    (await bench.text("#commands")).includes("fogcomp add cubic.model thermal_lag mems.csv -o grown.model"),
    await bench.text("#commands"),
  );
  check("report", /^helps out of sample/i.test(await bench.text(".judged")), await bench.text(".judged"));
  await bench.diagnosed();
  await bench.look("report");
  await bench.click("#undo");
  await bench.state(0);
  await bench.click("#show_report");
  check(
    "report",
    await bench.page.evaluate(
      `document.getElementById("report").checkVisibility() && !document.getElementById("bench").checkVisibility()`,
    ),
    "does not go back to what was found",
  );
  bench.silent();
  const plain = await new_page(browser);
  await plain.setJavaScriptEnabled(false);
  await plain.goto(address_of("report.html"));
  const words = await plain.evaluate("document.body.innerText");
  check(
    "report",
    /Accepted: helps out of sample/.test(words) && /Before and after/.test(words),
    "cannot be read without scripts",
  );
  check("report", !/Which recordings|What is missing\?/.test(words), "shows a dead workbench without scripts");
  const count = async (selector) => (await plain.$$(selector)).length;
  const [plots, stills] = [await count("figure.plot"), await count("figure.plot svg.still path")];
  check("report", plots > 0 && stills > 3 * plots, `draws ${stills} lines in ${plots} plots without scripts`);
  await picture(plain, "without_scripts");
};

// A run of 60,000 rows fits into 200 MB.
const long = async (browser) => {
  const bench = await Bench.open(browser, "long.html");
  await bench.state(0);
  await bench.click("#effect_temperature_rate");
  await bench.state(1);
  check(
    "long",
    (await bench.text("#notes")).includes("59550 means over 1 s"),
    "the page does not say that it has means",
  );
  const megabytes = (await bench.page.metrics()).JSHeapUsedSize / 1e6;
  check("long", megabytes < 200, `takes ${megabytes.toFixed(0)} MB`);
  bench.silent();
};

// A page without recordings takes files and asks about columns that are not clear.
const opened = async (browser) => {
  const bench = await Bench.open(browser, "empty.html");
  await bench.until(`!document.getElementById("opening").hidden`);
  // A file that cannot be read says why, and is taken away.
  await bench.choose_file("no_recording.csv");
  await bench.until(`/no_recording/.test(document.getElementById("dropped").textContent)`);
  check("files", await bench.page.evaluate(`document.getElementById("begin").disabled`), "begins without a recording");
  await bench.click(`[aria-label="remove no_recording.csv"]`);
  await bench.until(`document.getElementById("dropped").textContent === ""`);
  await bench.choose_file("foreign.csv");
  await bench.until(`document.getElementById("columns").open`);
  check("files", /Gyro_X.*or.*Gyro_Y/.test(await bench.text("#columns_said")), await bench.text("#columns_said"));
  check(
    "files",
    await bench.page.evaluate(`document.getElementById("columns_take").disabled`),
    "takes what is not clear",
  );
  check(
    "files",
    (await bench.text("#columns_file")).includes("columns separated by ';'"),
    await bench.text("#columns_file"),
  );
  await bench.listen("dialog", { announced: ["status"] });
  for (const width of [1280, 390]) {
    for (const dark of [false, true]) {
      await show(bench.page, { width, dark });
      await picture(bench.page, `dialog_${width}_${dark ? "dark" : "light"}`);
    }
  }
  await show(bench.page, { width: 1280, dark: false });
  await bench.key("Escape");
  await bench.until(`!document.getElementById("columns").open`);
  check(
    "files",
    await bench.page.evaluate(`document.getElementById("begin").disabled`),
    "begins with columns that are not clear",
  );
  await bench.click(`[aria-label="columns of foreign.csv"]`);
  await bench.until(`document.getElementById("columns").open`);
  const pick = (label, text) =>
    bench.page.evaluate(`(() => {
    const select = document.querySelector('[aria-label="${label}"]');
    select.value = [...select.options].find((option) => option.textContent === "${text}").value;
    select.dispatchEvent(new Event("change"));
  })()`);
  await pick("column of rate", "Gyro_Y");
  await bench.until(`/no unit/.test(document.getElementById("columns_said").textContent)`);
  await pick("unit of rate", "deg/h");
  await bench.until(`/no column 'time_s'/.test(document.getElementById("columns_said").textContent)`);
  await pick("column of time", "Stamp");
  await pick("unit of time", "s");
  await bench.until(`!document.getElementById("columns_take").disabled`);
  check("files", /read as .*Gyro_Y/.test(await bench.text("#columns_said")), await bench.text("#columns_said"));
  await bench.click("#columns_take");
  await bench.until(`/8399 samples/.test(document.getElementById("dropped").textContent)`);
  await bench.until(`!document.getElementById("begin").disabled`);
  await picture(bench.page, "files");
  await bench.listen("files");
  await bench.click("#begin");
  await bench.state(0);
  check(
    "files",
    /--columns '[^']*rate=Gyro_Y\[deg\/h\]'/.test(await bench.text("#commands")),
    await bench.text("#commands"),
  );
  bench.silent();
};

// A unit that a header has wrong is corrected in the dialog.
const units = async (browser) => {
  const bench = await Bench.open(browser, "empty.html");
  await bench.until(`!document.getElementById("opening").hidden`);
  await bench.choose_file("kelvin.csv");
  await bench.until(`/kelvin/.test(document.getElementById("dropped").textContent)`);
  await bench.click(`[aria-label="columns of kelvin.csv"]`);
  await bench.until(`document.getElementById("columns").open`);
  await choose(bench, `[aria-label="unit of temperature"]`, "K");
  await bench.until(`/in K, as chosen, not in °C/.test(document.getElementById("columns_said").textContent)`);
  await bench.click("#columns_take");
  await bench.until(`!document.getElementById("begin").disabled`);
  check("units", /8399 samples/.test(await bench.text("#dropped")), await bench.text("#dropped"));
  bench.silent();
};

// A large file is averaged once, with a bar; a recording of another gyro is noticed.
const large = async (browser) => {
  const bench = await Bench.open(browser, "empty.html");
  await bench.until(`!document.getElementById("opening").hidden`);
  await bench.choose_file("fast.csv");
  await bench.until(`!document.getElementById("begin").disabled`);
  check("large", /MB: .* means over 1 s/.test(await bench.text("#dropped")), await bench.text("#dropped"));
  await bench.page.evaluate(`window.widest = 0;
    new MutationObserver(() => { widest = Math.max(widest, parseFloat(byId("working").firstElementChild.style.width)); })
      .observe(byId("working"), { subtree: true, attributes: true });`);
  await bench.click("#begin");
  await bench.state(0);
  check("large", (await bench.page.evaluate("widest")) > 50, "no bar while a large file is averaged");
  check("large", /297750 samples.*59550 means/.test(await bench.text("#notes")), await bench.text("#notes"));
  await (await bench.page.$("#more")).uploadFile("loud.csv");
  await bench.state(1);
  check(
    "large",
    /loud.csv has .* times the noise of fast.csv/i.test(await bench.text("#notes")),
    await bench.text("#notes"),
  );
  check("large", await bench.page.evaluate(`byId("notes_box").open`), "a question is not seen");
  bench.silent();
};

const work = [loop, two_runs, keyboard, reload, recordings, looking, handling, session];
const files = [trouble, stepped, memory, escape, rate_table, report, long, opened, units, large];
const chosen = { work, files }[only] ?? [...work, ...files].filter((part) => part.name === only);
const browser = await launch(driver);
try {
  for (const part of chosen) {
    const begin = Date.now();
    await part(browser).catch((fault) => check(part.name, false, fault.message));
    console.log(`${part.name}: done in ${((Date.now() - begin) / 1000).toFixed(1)} s`);
  }
} finally {
  await browser.close();
}
process.exit(failures > 0 ? 1 : 0);
