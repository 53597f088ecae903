// workbench_ticks.mjs DRIVER PAGE.html: time in a headless Chromium, ms, from a click on an effect of the workbench's
// catalogue to the painted frame with the new fit: each effect ticked and cleared in turn, with the diagnosis of the
// state before it done. Median, smallest and largest of five.
import { launch, new_page, open, show } from "../report/browser.mjs";

const kRepeats = 5;
const [driver, file] = process.argv.slice(2);
if (!file) {
  console.error("usage: workbench_ticks.mjs DRIVER PAGE.html");
  process.exit(2);
}

const browser = await launch(driver);
const page = await new_page(browser);
await show(page, { width: 1280, dark: false });
await open(page, file);

const diagnosed = `(async () => {
  while (document.body.dataset.diagnosed !== "yes") await new Promise((done) => setTimeout(done, 20));
})()`;
// Resolves after the frame in which the state has changed has been painted.
const click = (id) => `new Promise((done, fail) => {
  const begun = performance.now();
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = () => done(performance.now() - begun);
  const seen = new MutationObserver(() => {
    seen.disconnect();
    requestAnimationFrame(() => port2.postMessage(null));
  });
  seen.observe(document.body, { attributeFilter: ["data-state"] });
  document.getElementById(${JSON.stringify(id)}).click();
  setTimeout(() => fail(new Error("no new state: " + document.getElementById("trouble").textContent)), 20000);
})`;
const numbers = (times) => {
  const [median, min, max] = [times.sort((a, b) => a - b)[times.length >> 1], times[0], times.at(-1)];
  return `${median.toFixed(0).padStart(4)} (${min.toFixed(0)} to ${max.toFixed(0)})`;
};

await page.evaluate(diagnosed);
const ids = await page.evaluate(
  `[...document.querySelectorAll('input[type=checkbox][id^="effect_"]')].filter((box) => !box.checked && !box.disabled)
    .map(({ id }) => id)`,
);
console.log(`${"effect".padEnd(28)} ${"ticked".padEnd(20)} cleared`);
for (const id of ids) {
  const times = { ticked: [], cleared: [] };
  let refused = "";
  for (let i = 0; i < kRepeats && !refused; ++i) {
    for (const all of [times.ticked, times.cleared]) {
      try {
        await page.evaluate(diagnosed);
        all.push(await page.evaluate(click(id)));
      } catch (fault) {
        refused = fault.message.split("\n")[0];
        break;
      }
    }
  }
  const name = id.replace("effect_", "").padEnd(28);
  console.log(refused ? `${name} ${refused}` : `${name} ${numbers(times.ticked).padEnd(20)} ${numbers(times.cleared)}`);
}
await browser.close();
