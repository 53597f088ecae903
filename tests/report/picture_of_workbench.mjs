// node picture_of_workbench.mjs DRIVER PAGE PICTURE: the workbench after what is missing was added, as a PNG.
import { launch, new_page, open, settle, show, until } from "./browser.mjs";

const [driver, file, picture] = process.argv.slice(2);
const browser = await launch(driver);
try {
  const page = await new_page(browser);
  await show(page, { width: 1280, dark: false });
  await open(page, file);
  const diagnosed = (state) =>
    until(page, `document.body.dataset.state === "${state}" && document.body.dataset.diagnosed === "yes"`);
  await diagnosed(0);
  await page.evaluate(`document.getElementById("add_missing").click()`);
  await diagnosed(1);
  await settle(page);
  await page.screenshot({ path: picture });
} finally {
  await browser.close();
}
