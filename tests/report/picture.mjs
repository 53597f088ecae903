// node picture.mjs DRIVER PAGE PICTURE PLOT...: of the report PAGE, only these plots (from 0), as a PNG.
import { launch, new_page, open, settle, show } from "./browser.mjs";

const [driver, file, picture, ...plots] = process.argv.slice(2);
const browser = await launch(driver);
try {
  const page = await new_page(browser);
  await show(page, { width: 860, dark: false });
  await open(page, file);
  await page.evaluate(`(() => {
    const wanted = ${JSON.stringify(plots.map(Number))};
    const figures = [...document.querySelectorAll("figure.plot")].filter((_, i) => wanted.includes(i));
    document.querySelector("main").replaceChildren(...figures);
    document.querySelector("main").style.padding = "8px 12px 0";
    for (const figure of figures) figure.style.margin = "0 0 8px";
  })()`);
  await settle(page);
  const height = await page.evaluate('document.querySelector("main").getBoundingClientRect().bottom');
  await page.screenshot({ path: picture, clip: { x: 0, y: 0, width: 860, height } });
} finally {
  await browser.close();
}
