// node picture_of_workbench.mjs CHROMIUM PAGE PICTURE: the workbench after what is missing was added, as a PNG.
import { writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";

const [program, page, picture] = process.argv.slice(2);
const browser = new Browser(program);
try {
  const tab = await browser.tab();
  await tab.show({ width: 1280, dark: false });
  await tab.open(pathToFileURL(resolve(page)).href);
  const until = async (expression) => {
    while (!(await tab.evaluate(expression))) await new Promise((done) => setTimeout(done, 50));
  };
  const diagnosed = (state) =>
    until(`document.body.dataset.state === "${state}" && document.body.dataset.diagnosed === "yes"`);
  await diagnosed(0);
  await tab.evaluate(`document.getElementById("add_missing").click()`);
  await diagnosed(1);
  await tab.settle();
  const clip = { x: 0, y: 0, width: 1280, height: 900, scale: 1 };
  const { data } = await tab.send("Page.captureScreenshot", { clip });
  writeFileSync(picture, Buffer.from(data, "base64"));
} finally {
  await browser.close();
}
