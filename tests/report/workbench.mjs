// node workbench.mjs CHROMIUM SHOTS: what workbench.sh says, on its pages in this folder; leaves the commands of a random
// session and the model that the page made of it.
import { writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";

const [program, shots] = process.argv.slice(2);
let failures = 0;
const check = (name, good, what) => {
  if (good) return;
  ++failures;
  console.error(`${name}: ${what}`);
};

// A page, with what a reader does on it.
class Bench {
  static async open(browser, name, shape = { width: 1280, dark: false }) {
    const bench = new Bench();
    bench.name = name;
    bench.tab = await browser.tab();
    // Tests see the workers, and what is saved.
    await bench.tab.send("Page.addScriptToEvaluateOnNewDocument", { source: `
      window.workers = [];
      window.Worker = class extends Worker { constructor(...all) { super(...all); workers.push(this); } };
      const address_of = URL.createObjectURL;
      URL.createObjectURL = (blob) => { if (blob.type === "") window.saved = blob; return address_of(blob); };
      if (navigator.clipboard) navigator.clipboard.writeText = async (text) => { window.copied = text; };` });
    await bench.tab.show(shape);
    await bench.tab.open(pathToFileURL(resolve(name)).href);
    return bench;
  }

  async until(expression, what, seconds = 60) {
    const end = Date.now() + 1000 * seconds;
    while (Date.now() < end) {
      if (await this.tab.evaluate(expression)) return;
      await new Promise((done) => setTimeout(done, 25));
    }
    throw new Error(`${this.name}: ${what} does not come; ${await this.tab.evaluate("document.body.innerText.slice(0, 600)")}`);
  }
  state(index) { return this.until(`document.body.dataset.state === "${index}"`, `state ${index}`); }
  diagnosed() { return this.until(`document.body.dataset.diagnosed === "yes"`, "the diagnosis"); }
  text(selector) { return this.tab.evaluate(`document.querySelector(${JSON.stringify(selector)})?.textContent ?? ""`); }

  async middle(selector) {
    return this.tab.evaluate(`(() => {
      const element = document.querySelector(${JSON.stringify(selector)});
      element.scrollIntoView({ block: "center" });
      const { left, top, width, height } = element.getBoundingClientRect();
      return { x: left + width / 2, y: top + height / 2, left, width };
    })()`);
  }
  async hover(selector) {
    const { x, y } = await this.middle(selector);
    await this.tab.mouse("mouseMoved", x, y);
  }
  async click(selector) {
    const { x, y } = await this.middle(selector);
    await this.tab.mouse("mouseMoved", x, y);
    await this.tab.mouse("mousePressed", x, y, { button: "left", buttons: 1, clickCount: 1 });
    await this.tab.mouse("mouseReleased", x, y, { button: "left", clickCount: 1 });
  }
  async drag(selector, from, to) {
    const { left, width, y } = await this.middle(selector);
    await this.tab.mouse("mouseMoved", left + from * width, y);
    await this.tab.mouse("mousePressed", left + from * width, y, { button: "left", buttons: 1, clickCount: 1 });
    await this.tab.mouse("mouseMoved", left + to * width, y, { button: "left", buttons: 1 });
    await this.tab.mouse("mouseReleased", left + to * width, y, { button: "left", clickCount: 1 });
  }
  async key(key, code, modifiers = 0) {
    const text = key.length === 1 && modifiers === 0 ? { text: key } : {};
    const number = { Tab: 9, Enter: 13, " ": 32, z: 90, y: 89 }[key];
    await this.tab.send("Input.dispatchKeyEvent", { type: "keyDown", key, code, modifiers, windowsVirtualKeyCode: number, ...text });
    await this.tab.send("Input.dispatchKeyEvent", { type: "keyUp", key, code, modifiers, windowsVirtualKeyCode: number });
  }

  // The error of the state that is shown, from the ladder.
  async error() { return Number(await this.text("#ladder [aria-current] .value")); }

  // Paper, width, names, console and requests, wide and narrow, light and dark.
  async look(label) {
    for (const width of [1280, 390]) {
      for (const dark of [false, true]) {
        await this.tab.show({ width, dark });
        const seen = await this.tab.evaluate(`(() => {
          const [r, g, b] = getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number);
          const named = (element) => element.ariaLabel || element.labels?.[0]?.textContent.trim() || element.textContent.trim();
          return {
            paper: (r + g + b) / 3, sideways: document.documentElement.scrollWidth - innerWidth,
            nameless: [...document.querySelectorAll("button, input, select")].filter((element) => element.checkVisibility() && !named(element)).length,
            coloured: [...document.querySelectorAll("#bench canvas")].map((canvas) => {
              const copy = Object.assign(document.createElement("canvas"), { width: canvas.width, height: canvas.height });
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
        check(view, seen.coloured.length === 3 && seen.coloured.every((count) => count > 40), `coloured pixels: ${seen.coloured}`);
        if (shots) writeFileSync(join(shots, `${label}_${width}_${dark ? "dark" : "light"}.png`), await this.tab.screenshot());
      }
    }
    await this.tab.show({ width: 1280, dark: false });
  }
  silent() {
    check(this.name, this.tab.complaints.length === 0, `the console says: ${this.tab.complaints.join("; ")}`);
    const others = this.tab.requests.filter((request) => !request.startsWith("file://") && !request.startsWith("blob:"));
    check(this.name, others.length === 0, `asks for ${others.join(", ")}`);
    check(this.name, this.tab.requests.filter((request) => request.startsWith("file://")).length === 1, "reads another file");
  }
}

// Compare, see where it fails, learn what is missing, add it, watch the error fall; and back again.
const loop = async (browser) => {
  const bench = await Bench.open(browser, "loop.html");
  await bench.state(0);
  check("loop", (await bench.text("#found")).startsWith("Residual 852.3 against a floor of 9.679"), await bench.text("#found"));
  await bench.diagnosed();
  check("loop", (await bench.text("#diagnosis .verdict")).startsWith("Several effects together are missing"), await bench.text("#diagnosis"));
  await bench.look("before");
  await bench.hover("#diagnosis tbody tr");
  await bench.until(`document.getElementById("candidate").textContent.startsWith("with ")`, "the candidate under the mouse");
  if (shots) writeFileSync(join(shots, "candidate.png"), await bench.tab.screenshot());
  const before = await bench.error();
  await bench.click("#add_missing");
  await bench.state(1);
  const after = await bench.error();
  check("loop", after < before / 5, `adding what is missing leaves ${after} of ${before}`);
  check("loop", /^.?.?Helps out of sample|^helps out of sample/i.test(await bench.text(".judged")), await bench.text(".judged"));
  await bench.diagnosed();
  await bench.look("after");
  await bench.key("z", "KeyZ", 2);
  await bench.state(0);
  check("loop", await bench.error() === before, "Ctrl+Z does not undo");
  await bench.click("#redo");
  await bench.state(1);
  // Rows are masked by a drag, listed, and counted again.
  await bench.click("#mask_mode");
  await bench.drag("#residual_plot .u-over", 0.2, 0.3);
  await bench.state(2);
  check("loop", /mems.csv \d+\.\.\d+ s/.test(await bench.text("#masks")), "masked rows are not listed");
  check("loop", /--mask \d+\.\.\d+/.test(await bench.text("#commands")), "the mask is in no command");
  await bench.click("#masks button");
  await bench.state(3);
  check("loop", await bench.text("#masks") === "", "a mask cannot be taken away");
  await bench.diagnosed();
  // What does not help is refused with the reason, and added all the same on request.
  await bench.click(`#diagnosis [aria-label="Add temperature_rate"]`);
  await bench.until(`document.querySelector(".judged button")`, "a refusal");
  check("loop", (await bench.text(".judged")).startsWith("Not added. "), await bench.text(".judged"));
  await bench.click(".judged button");
  await bench.state(4);
  check("loop", (await bench.text("#commands")).includes("--force"), "the command does not force it");
  // A formula says what is wrong with it as it is typed.
  await bench.click("#expression");
  await bench.tab.send("Input.insertText", { text: "x = T*T*" });
  await bench.until(`/column 9/.test(document.getElementById("formula_error").textContent)`, "the formula's error");
  bench.silent();
};

// With the keyboard alone: to an effect of the catalogue, and into the model with it.
const keyboard = async (browser) => {
  const bench = await Bench.open(browser, "loop.html");
  await bench.state(0);
  await bench.diagnosed();
  const focus = () => bench.tab.evaluate("document.activeElement.id");
  for (let presses = 0; presses < 60 && await focus() !== "effect_temperature_rate"; ++presses) await bench.key("Tab", "Tab");
  check("keyboard", await focus() === "effect_temperature_rate", `Tab does not come to the effects but to ${await focus()}`);
  await bench.key(" ", "Space");
  await bench.state(1);
  check("keyboard", await bench.tab.evaluate(`document.getElementById("effect_temperature_rate").checked`), "Space does not tick");
  bench.silent();
};

// Ticks and masks by chance, by a real mouse; what the page then shows to be typed is left for a shell.
const session = async (browser) => {
  const bench = await Bench.open(browser, "session.html");
  await bench.state(0);
  await bench.diagnosed();
  const effects = ["bias_temperature", "temperature_rate", "polarization_ripple", "thermal_lag", "shupe", "thermal_hysteresis"];
  let draw = 20261123;
  const chance = (most) => { draw = (draw * 1103515245 + 12345) % 2147483648; return draw % most; };
  for (let step = 1; step <= 6; ++step) {
    if (step === 4) await bench.click("#mask_mode");
    if (step === 4) await bench.drag("#residual_plot .u-over", 0.4, 0.45);
    else await bench.click(`#effect_${effects[chance(effects.length)]}`);
    await bench.until(`document.body.dataset.state === "${step}" || !document.getElementById("trouble").hidden`, `step ${step}`);
    check("session", await bench.tab.evaluate(`document.getElementById("trouble").hidden`), await bench.text("#trouble"));
  }
  await bench.diagnosed();
  if (await bench.tab.evaluate(`Boolean(document.getElementById("add_missing"))`)) {
    await bench.click("#add_missing");
    await bench.until(`document.body.dataset.state === "7" || document.querySelector(".judged")`, "a judgement");
  }
  await bench.click("#save_model");
  await bench.until("window.saved", "the model file");
  writeFileSync("page.model", await bench.tab.evaluate("window.saved.text()"));
  await bench.click("#copy_commands");
  await bench.until("window.copied", "the commands");
  writeFileSync("commands.txt", await bench.tab.evaluate("window.copied") + "\n");
  const error = await bench.error();
  await bench.look("session");
  // The same state from its link.
  await bench.tab.evaluate("window.copied = ''");
  await bench.click("#link");
  await bench.until("window.copied", "the link");
  const link = await bench.tab.evaluate("window.copied");
  const count = (await bench.text("#commands")).split("$ ").length - 1;
  const other = await browser.tab();
  await other.open("about:blank");
  const again = new Bench();
  again.name = "link";
  again.tab = other;
  await other.open(link);
  await again.state(count - 1);
  check("link", await again.error() === error, `leaves ${await again.error()}, not ${error}`);
  bench.silent();
};

// Names from files are text. An engine that stops is started again, and the page goes on.
const trouble = async (browser) => {
  const bench = await Bench.open(browser, "hostile.html");
  await bench.state(0);
  check("hostile", await bench.tab.evaluate(`document.querySelectorAll("img, main b").length === 0 && document.title !== "gone"`), "a name became markup");
  check("hostile", (await bench.text("header .subject")).includes("<img src=x"), "the name is not shown as it is");
  await bench.tab.evaluate("workers[0].postMessage({ id: 0, words: null, files: [], columns: [] })");
  await bench.until(`/engine stopped/.test(document.getElementById("trouble").textContent)`, "the reason");
  await bench.click("#effect_bias_temperature");
  await bench.state(1);
  check("hostile", await bench.tab.evaluate(`document.getElementById("trouble").hidden`), "the page does not go on");
  bench.silent();
};

// 60,000 rows.
const long = async (browser) => {
  const bench = await Bench.open(browser, "long.html");
  await bench.state(0);
  await bench.click("#effect_temperature_rate");
  await bench.state(1);
  check("long", (await bench.text("#notes")).includes("59550 means over 1 s"), "the page does not say that it has means");
  await bench.tab.send("Performance.enable");
  const { metrics } = await bench.tab.send("Performance.getMetrics");
  const megabytes = metrics.find(({ name }) => name === "JSHeapUsedSize").value / 1e6;
  check("long", megabytes < 200, `takes ${megabytes.toFixed(0)} MB`);
  bench.silent();
};

// A page without data takes files.
const files = async (browser) => {
  const bench = await Bench.open(browser, "empty.html");
  await bench.until(`!document.getElementById("opening").hidden`, "the question for files");
  const { root } = await bench.tab.send("DOM.getDocument");
  const { nodeId } = await bench.tab.send("DOM.querySelector", { nodeId: root.nodeId, selector: "#chosen" });
  await bench.tab.send("DOM.setFileInputFiles", { nodeId, files: [resolve("mems.csv")] });
  await bench.until(`/8399 rows/.test(document.getElementById("dropped").textContent)`, "what was understood of the file");
  await bench.until(`!document.getElementById("begin").disabled`, "the button");
  if (shots) writeFileSync(join(shots, "files.png"), await bench.tab.screenshot());
  await bench.click("#begin");
  await bench.state(0);
  bench.silent();
};

const browser = new Browser(program);
try {
  for (const part of [loop, keyboard, session, trouble, long, files]) {
    await part(browser);
    console.log(`${part.name}: done`);
  }
} finally {
  await browser.close();
}
process.exit(failures > 0 ? 1 : 0);
