// Debian's Chromium, headless, driven by puppeteer-core; pages of files, what they complain of and ask for.
import { createRequire } from "node:module";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

// `driver`: where puppeteer-core is installed by browser_driver/package-lock.json.
export const launch = (driver) =>
  createRequire(resolve(driver, "package.json"))("puppeteer-core").launch({
    executablePath: "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu", "--disable-quic"],
    pipe: true,
    protocolTimeout: 300_000, // ms: a busy machine
  });

export const address_of = (file) => pathToFileURL(resolve(file)).href;

// A new tab with `complaints` (whatever comes on its console, and exceptions) and `requests` (addresses asked for).
export const new_page = async (browser) => {
  const page = Object.assign(await browser.newPage(), { complaints: [], requests: [] });
  page.setDefaultTimeout(0); // the test as a whole has one
  page.on("console", (said) => said.type() === "verbose" || page.complaints.push(said.text()));
  page.on("pageerror", (error) => page.complaints.push(error.stack ?? String(error)));
  page.on("request", (request) => page.requests.push(request.url()));
  return page;
};

// Two frames: one in which observers run, one in which what they changed is drawn.
export const settle = (page) =>
  page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 0))))");

export const show = async (page, { width, dark }) => {
  await page.setViewport({ width, height: width < 600 ? 844 : 900 });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: dark ? "dark" : "light" }]);
  await settle(page);
};

export const open = async (page, file) => {
  await page.goto(address_of(file));
  await settle(page);
};

// Until `expression` is true of the page. puppeteer's own way evaluates a string in the page, whose policy forbids that.
export const until = async (page, expression, seconds = 300) => {
  for (const end = Date.now() + 1000 * seconds; Date.now() < end; ) {
    if (await page.evaluate(expression)) return;
    await new Promise((done) => setTimeout(done, 25));
  }
  throw new Error(
    `${page.url()}: ${expression} does not come: ` +
      (await page.evaluate("document.body.innerText.replace(/\\s+/g, ' ').slice(0, 600)")),
  );
};

export const drag = async (page, from, to, meanwhile = async () => {}) => {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y);
  await meanwhile();
  await page.mouse.up();
};
