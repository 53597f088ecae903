// node look_at_pages.mjs DRIVER SHOTS PAGE=PLOTS...: opens each report from its file, wide and narrow, light
// and dark, and says what is wrong with it. PLOTS: how many it must have. SHOTS: a folder for screenshots and
// a print, "" for none.
import { basename, join } from "node:path";
import { address_of, drag, launch, new_page, open, settle, show } from "./browser.mjs";

const [driver, shots, ...pages] = process.argv.slice(2);
let failures = 0;

// What is visible: brightness of the page, overflow to the side, and for each plot the number of coloured
// pixels (only curves are coloured), whether it fits its box, and how many points of the data it lacks (a
// stack has more: both signs, and zero).
const look = `(() => {
  const data = JSON.parse(document.getElementById("plots").textContent);
  const [r, g, b] = getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number);
  return {
    paper: (r + g + b) / 3,
    sideways: document.documentElement.scrollWidth - innerWidth,
    words: document.querySelector("h1").textContent.length,
    // Of a table that is too wide for the window: can it be scrolled, is there a sign, and what stays in view?
    tables: [...document.querySelectorAll("#report table:not(.u-legend)")].map((table) => {
      const box = table.parentElement;
      const heads = [...table.querySelectorAll("thead th")].map((head) => head.getBoundingClientRect());
      const { overflowX, backgroundImage } = getComputedStyle(box);
      const broken = [...table.querySelectorAll("th")].some((cell) => cell.getBoundingClientRect().width < 40);
      return {
        wide: table.scrollWidth > box.clientWidth, scrolls: /auto|scroll/.test(overflowX),
        sign: /gradient/.test(backgroundImage),
        keeps_name: getComputedStyle(table.querySelector("tbody th")).position === "sticky",
        deciding: heads[Math.min(1, heads.length - 1)].right - innerWidth, broken,
      };
    }),
    hidden_listings: [...document.querySelectorAll("#report pre")].filter((pre) => pre.scrollWidth > pre.clientWidth &&
      !/gradient/.test(getComputedStyle(pre).backgroundImage)).length,
    captions: [...document.querySelectorAll("#report figcaption")].map((caption) => caption.textContent),
    unnamed_axes: [...document.querySelectorAll("figure.bars")]
      .filter((figure) => !figure.querySelector(".quantity")?.textContent).length,
    help: /click on a name in a legend/.test(document.querySelector("footer")?.textContent),
    legends: [...document.querySelectorAll(".u-legend .u-series")].map((row) => ({
      text: row.textContent, colon: getComputedStyle(row.querySelector("th"), "::after").content.includes(":") })),
    plots: [...document.querySelectorAll("#report .canvas")].map((box) => {
      const canvas = box.querySelector("canvas");
      if (!canvas) return { coloured: 0, wide: true };
      const copy = Object.assign(document.createElement("canvas"), { width: canvas.width, height: canvas.height });
      const pen = copy.getContext("2d", { willReadFrequently: true });
      pen.drawImage(canvas, 0, 0);
      const pixels = pen.getImageData(0, 0, copy.width, copy.height).data;
      let coloured = 0;
      for (let i = 0; i < pixels.length; i += 4) {
        const rgb = [pixels[i], pixels[i + 1], pixels[i + 2]];
        if (pixels[i + 3] > 60 && Math.max(...rgb) - Math.min(...rgb) > 60) ++coloured;
      }
      const points = data[box.dataset.plot].curves.flatMap((curve) => curve.y).filter((y) => y !== null).length;
      const { x_label, y_label, bands } = data[box.dataset.plot];
      return {
        labels: [x_label, y_label], over_time: /^time since/.test(x_label),
        ramps: (bands || []).filter((band) => band.colour).length,
        shaded: Number(box.dataset.shaded), named: Number(box.dataset.named),
        coloured, lost: points - Number(box.dataset.points),
        wide: canvas.getBoundingClientRect().right > box.getBoundingClientRect().right + 1,
      };
    }),
  };
})()`;
const pictures = `[...document.querySelectorAll("#report .canvas canvas")].map((canvas) => canvas.toDataURL())`;

// Whether all tables fit between the margins of A4 when printed.
const fits_the_paper = `(async () => {
  const style = document.createElement("style");
  const printed = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules])
    .filter((rule) => rule.conditionText === "print").flatMap((rule) => [...rule.cssRules])
    .filter((rule) => rule.selectorText).map((rule) => rule.cssText);
  style.textContent = printed.join("\\n") + " main { width: 690px; }";
  document.head.append(style);
  const fits = [...document.querySelectorAll("#report table:not(.u-legend)")]
    .every((table) => table.getBoundingClientRect().width <= 690);
  style.remove();
  return fits;
})()`;

const check = (name, good, what) => {
  if (good) return;
  ++failures;
  console.error(`${name}: ${what}`);
};

const look_at = async (page, name, shape, plots) => {
  await show(page, shape);
  const view = `${name}, ${shape.width} px, ${shape.dark ? "dark" : "light"}`;
  const seen = await page.evaluate(look);
  check(view, shape.dark ? seen.paper < 60 : seen.paper > 230, `paper of brightness ${seen.paper}`);
  check(view, seen.sideways <= 0, `is ${seen.sideways} px wider than the window`);
  check(view, seen.words > 20, "does not say what was found");
  check(view, seen.plots.length === plots, `has ${seen.plots.length} plots, not ${plots}`);
  seen.plots.forEach((plot, i) => {
    check(view, plot.coloured > 40, `plot ${i} shows no curve (${plot.coloured} coloured pixels)`);
    check(view, plot.lost <= 0, `plot ${i} lacks ${plot.lost} of its points`);
    check(view, !plot.wide, `plot ${i} is wider than its box`);
    check(
      view,
      !plot.labels.some((label) => /_|deg|^gyro,/.test(label)),
      `plot ${i} has axes "${plot.labels.join('", "')}"`,
    );
    if (!plot.over_time) return;
    check(view, plot.ramps > 0 && plot.shaded === plot.ramps, `plot ${i} shades ${plot.shaded} of ${plot.ramps} ramps`);
    check(view, plot.named > 0, `plot ${i} names no segment`);
  });
  seen.tables.forEach((table, i) => {
    check(view, !table.broken, `table ${i} breaks a name letter by letter`);
    if (!table.wide) return;
    check(view, table.scrolls && table.sign, `table ${i} is cut off without a sign that it can be scrolled`);
    check(view, shape.width > 600 || table.keeps_name, `table ${i} loses the names of its rows`);
    check(view, table.deciding <= 0, `the first figures of table ${i} are out of view`);
  });
  const technical = seen.captions.find((caption) => /columns|\d rows|is the mean of/.test(caption));
  check(view, technical === undefined, `a caption says how it was made: ${technical}`);
  check(view, seen.hidden_listings === 0, `${seen.hidden_listings} listings are cut off without a sign`);
  check(view, seen.unnamed_axes === 0, `${seen.unnamed_axes} lists of bars do not say what they are of`);
  check(view, seen.help, "does not say that a click in a legend hides a curve");
  check(view, !seen.legends.some(({ text, colon }) => colon || /[–:]\s*$/.test(text)), "a legend waits for a cursor");
  const shot = `${basename(name, ".html")}_${shape.width}_${shape.dark ? "dark" : "light"}.png`;
  if (shots) await page.screenshot({ path: join(shots, shot), fullPage: true });
};

// The first two plots share time: a cursor over one shows figures in the legends of both, a drag zooms both, a
// double click shows all again.
const zoom = async (page, name) => {
  const place = await page.evaluate(`(() => {
    const over = document.querySelector("#report .canvas .u-over");
    over.scrollIntoView({ block: "center" });
    const { left, top, width, height } = over.getBoundingClientRect();
    return { left, top: top + height / 2, width };
  })()`);
  const before = await page.evaluate(pictures);
  const at = (share) => ({ x: place.left + share * place.width, y: place.top });
  await page.mouse.move(at(0.3).x, at(0.3).y);
  await settle(page);
  const legends = await page.evaluate(
    `[...document.querySelectorAll("#report .canvas .u-legend")].slice(0, 2).map((legend) => legend.textContent)`,
  );
  check(
    name,
    legends.every((legend) => /\d/.test(legend)),
    `the linked cursor shows no figures: ${legends.join(" | ")}`,
  );
  await drag(page, at(0.3), at(0.5));
  await settle(page);
  const zoomed = await page.evaluate(pictures);
  check(name, zoomed[0] !== before[0], "dragging does not zoom");
  check(name, zoomed[1] !== before[1], "the zoom is not linked to the next plot over time");
  await page.mouse.click(at(0.4).x, at(0.4).y, { count: 2 });
  await settle(page);
  const after = await page.evaluate(pictures);
  check(
    name,
    after.every((picture, i) => picture === before[i]),
    "a double click does not show all again",
  );
};

// A drag upwards zooms this plot's y alone; a click on a name in the legend hides its curve.
const zoom_y_and_hide = async (page, name) => {
  const place = await page.evaluate(`(() => {
    const { left, top, width, height } = document.querySelector("#report .canvas .u-over").getBoundingClientRect();
    return { x: left + width / 2, y: top + 0.7 * height, to: top + 0.3 * height };
  })()`);
  const before = await page.evaluate(pictures);
  await drag(page, place, { x: place.x + 3, y: place.to });
  await settle(page);
  const zoomed = await page.evaluate(pictures);
  check(name, zoomed[0] !== before[0], "a drag upwards does not zoom");
  check(
    name,
    zoomed.slice(1).every((picture, i) => picture === before[i + 1]),
    "a drag upwards changes other plots",
  );
  await page.mouse.click(place.x, place.y, { count: 2 });
  await settle(page);
  check(name, (await page.evaluate(pictures))[0] === before[0], "a double click does not undo a drag upwards");
  const click = 'document.querySelectorAll("#report .canvas .u-legend .u-series")[1].querySelector("th").click()';
  await page.evaluate(click);
  await settle(page);
  check(name, (await page.evaluate(pictures))[0] !== before[0], "a click in the legend does not hide a curve");
  await page.evaluate(click);
  await settle(page);
};

const browser = await launch(driver);
try {
  for (const word of pages) {
    const [file, plots] = word.split("=");
    const name = basename(file);
    const page = await new_page(browser);
    await show(page, { width: 1280, dark: false });
    await open(page, file);
    for (const width of [1280, 390]) {
      const themes = shots ? [false, true] : [width === 390]; // wide and light, narrow and dark
      for (const dark of themes) await look_at(page, name, { width, dark }, Number(plots));
    }
    await show(page, { width: 1280, dark: false });
    if (Number(plots) > 1) {
      await zoom(page, name);
      await zoom_y_and_hide(page, name);
    }
    await show(page, { width: 1280, dark: true });
    const before = await page.evaluate(pictures);
    const print = await page.pdf({
      timeout: 0,
      preferCSSPageSize: true,
      path: shots ? join(shots, basename(name, ".html") + ".pdf") : undefined,
    });
    check(name, await page.evaluate(fits_the_paper), "a table is wider than the paper");
    check(name, Buffer.from(print.subarray(0, 5)).toString() === "%PDF-", "cannot be printed");
    await settle(page);
    check(
      name,
      (await page.evaluate(pictures)).every((picture, i) => picture === before[i]),
      "the plots are not as before after printing",
    );
    check(name, page.complaints.length === 0, `the console says: ${page.complaints.join("; ")}`);
    const others = page.requests.filter((request) => request !== address_of(file));
    check(name, others.length === 0, `asks for ${others.join(", ")}`);
    console.log(`${name}: ${plots} plots`);
  }
} finally {
  await browser.close();
}
process.exit(failures > 0 ? 1 : 0);
