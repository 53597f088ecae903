// node picture.mjs CHROMIUM PAGE PICTURE PLOT...: of the report PAGE, only these plots (from 0), as a PNG.
import { writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";

const [program, page, picture, ...plots] = process.argv.slice(2);
const browser = new Browser(program);
try {
  const tab = await browser.tab();
  await tab.show({ width: 860, dark: false });
  await tab.open(pathToFileURL(resolve(page)).href);
  await tab.evaluate(`(() => {
    const wanted = ${JSON.stringify(plots.map(Number))};
    const figures = [...document.querySelectorAll("figure.plot")].filter((_, i) => wanted.includes(i));
    document.querySelector("main").replaceChildren(...figures);
    document.querySelector("main").style.padding = "8px 12px 0";
    for (const figure of figures) figure.style.margin = "0 0 8px";
  })()`);
  await tab.settle();
  const height = await tab.evaluate('document.querySelector("main").getBoundingClientRect().bottom');
  const clip = { x: 0, y: 0, width: 860, height, scale: 1 };
  const { data } = await tab.send("Page.captureScreenshot", { clip, captureBeyondViewport: true });
  writeFileSync(picture, Buffer.from(data, "base64"));
} finally {
  await browser.close();
}
