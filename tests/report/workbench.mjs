// node workbench.mjs DRIVER SHOTS [PART]: what workbench.sh says, on its pages in this folder; leaves the page's first
// diagnosis, that of two runs, the commands of a random session and the model that the page made of it.
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
    check(
      this.name,
      this.page.requests.filter((request) => request.startsWith("file://")).length === 1,
      "reads another file",
    );
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
    (await bench.text("#diagnosis .verdict")).startsWith("thermal_lag is missing"),
    await bench.text("#diagnosis"),
  );
  const diagnosis = await bench.page.evaluate("JSON.stringify(states.now.diagnosis.diagnosis, null, 1)");
  writeFileSync("page_diagnosis.json", diagnosis);
  await bench.look("before");
  await bench.listen("loop", { announced: ["status"] });
  await bench.hover("#diagnosis tbody tr");
  await bench.until(`document.getElementById("candidate").textContent.startsWith("with ")`);
  await picture(bench.page, "candidate");
  const before = await bench.error();
  // An effect that does not help is refused with the reason, and added on request.
  await bench.click(`#diagnosis [aria-label="Add aging"]`);
  await bench.until(`document.querySelector(".judged button")`);
  check("loop", (await bench.text(".judged")).startsWith("Not added. "), await bench.text(".judged"));
  await bench.click(".judged button");
  await bench.state(1);
  check("loop", (await bench.text("#commands")).includes("--force"), "the command does not force it");
  await bench.undo();
  await bench.state(0);
  await bench.diagnosed();
  await bench.click("#add_missing");
  await bench.state(1);
  const between = await bench.error();
  await bench.diagnosed();
  await bench.click("#add_missing");
  await bench.state(2);
  const after = await bench.error();
  check("loop", after < between && after < before / 5, `adding what is missing leaves ${after} of ${before}`);
  check(
    "loop",
    /^.?.?Helps out of sample|^helps out of sample/i.test(await bench.text(".judged")),
    await bench.text(".judged"),
  );
  await bench.diagnosed();
  await bench.look("after");
  await bench.undo();
  await bench.state(1);
  check("loop", (await bench.error()) === between, "Ctrl+Z does not undo");
  await bench.click("#redo");
  await bench.state(2);
  // Rows are masked by a drag, listed, and counted again.
  await bench.click("#mask_mode");
  await bench.drag("#residual_plot .u-over", 0.2, 0.3);
  await bench.state(3);
  check("loop", /mems.csv \d+\.\.\d+ s/.test(await bench.text("#masks")), "masked rows are not listed");
  check("loop", /--mask \d+\.\.\d+/.test(await bench.text("#commands")), "the mask is in no command");
  await bench.click("#masks button");
  await bench.state(4);
  check("loop", (await bench.text("#masks")) === "", "a mask cannot be taken away");
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

// With the keyboard alone: Tab to an effect of the catalogue, Space adds it.
const keyboard = async (browser) => {
  const bench = await Bench.open(browser, "loop.html");
  await bench.state(0);
  await bench.diagnosed();
  const focus = () => bench.page.evaluate("document.activeElement.id");
  for (let presses = 0; presses < 60 && (await focus()) !== "effect_temperature_rate"; ++presses)
    await bench.key("Tab");
  check(
    "keyboard",
    (await focus()) === "effect_temperature_rate",
    `Tab does not come to the effects but to ${await focus()}`,
  );
  await bench.key("Space");
  await bench.state(1);
  check(
    "keyboard",
    await bench.page.evaluate(`document.getElementById("effect_temperature_rate").checked`),
    "Space does not tick",
  );
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
  const count = (await bench.text("#commands")).split("$ ").length - 1;
  const again = new Bench();
  again.name = "link";
  again.page = await new_page(browser);
  await again.page.goto(link);
  await again.state(count - 1);
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

// A bias step that is looked for and not found leaves the model as it is, and says so.
const steady = async (browser) => {
  const bench = await Bench.open(browser, "steady.html");
  await bench.state(0);
  await bench.click("#effect_bias_step");
  await bench.until(`/^No bias step stands out/.test(document.getElementById("trouble").textContent)`);
  check("steady", await bench.page.evaluate(`document.body.dataset.state === "0"`), "a state without a change");
  await bench.click("#effect_warm_up");
  await bench.state(1);
  check("steady", await bench.page.evaluate(`document.getElementById("trouble").hidden`), "the page does not go on");
  bench.silent();
};

// Whose bias the model has where a bias step is found, as `fit` says it.
const stepped = async (browser) => {
  const bench = await Bench.open(browser, "stepped.html");
  await bench.state(0);
  await bench.click("#effect_bias_step");
  await bench.state(1);
  const side = "; the model's bias is that after it.";
  for (const place of ["notes", "effects"]) {
    const text = await bench.page.evaluate(`document.getElementById("${place}").textContent`);
    check("stepped", text.includes(side), `${place} say nothing of the model's bias: ${text}`);
  }
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
  await bench.drag(slider, 0.3, 0.8);
  await bench.state(2);
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
    (await bench.text("#commands")).includes("fogcomp add cubic.model temperature_rate mems.csv -o grown.model"),
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
const files = async (browser) => {
  const bench = await Bench.open(browser, "empty.html");
  await bench.until(`!document.getElementById("opening").hidden`);
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
  const choose = (label, text) =>
    bench.page.evaluate(`(() => {
    const select = document.querySelector('[aria-label="${label}"]');
    select.value = [...select.options].find((option) => option.textContent === "${text}").value;
    select.dispatchEvent(new Event("change"));
  })()`);
  await choose("column of rate", "Gyro_Y");
  await bench.until(`/no unit/.test(document.getElementById("columns_said").textContent)`);
  await choose("unit of rate", "deg/h");
  await bench.until(`/no column 'time_s'/.test(document.getElementById("columns_said").textContent)`);
  await choose("column of time", "Stamp");
  await choose("unit of time", "s");
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

const parts = {
  loop,
  two_runs,
  keyboard,
  session,
  trouble,
  steady,
  stepped,
  memory,
  escape,
  rate_table,
  report,
  long,
  files,
};
const browser = await launch(driver);
try {
  for (const part of only ? [parts[only]] : Object.values(parts)) {
    const begin = Date.now();
    await part(browser);
    console.log(`${part.name}: done in ${((Date.now() - begin) / 1000).toFixed(1)} s`);
  }
} finally {
  await browser.close();
}
process.exit(failures > 0 ? 1 : 0);
