// Drawing helpers of all plots, over uPlot.
"use strict";
const root = document.documentElement;
const byId = (id) => document.getElementById(id);

// The value of the style sheet's colour --name, as #rrggbb or #rrggbbaa.
const colour = (name, opacity = 1) => {
  const hex = getComputedStyle(root)
    .getPropertyValue("--" + name)
    .trim();
  return opacity < 1
    ? hex +
        Math.round(255 * opacity)
          .toString(16)
          .padStart(2, "0")
    : hex;
};
const significant = (value, digits = 4) =>
  value == null || !isFinite(value) ? "" : String(Number(value.toPrecision(digits)));
// Decimals that show a step exactly, at most 9.
const decimals = (step) => {
  let places = 0;
  while (places < 9 && Math.abs(step * 10 ** places - Math.round(step * 10 ** places)) > 1e-6) ++places;
  return places;
};

const figures = (size, weight = "") => `${weight}${size}px system-ui, sans-serif`;
const axis = (label, extra) => ({
  label,
  font: figures(12),
  labelFont: figures(12),
  labelSize: 20,
  stroke: () => colour("ink"),
  grid: { stroke: () => colour("rule"), width: 1 },
  ticks: { stroke: () => colour("rule"), width: 1, size: 5 },
  values: (u, splits, a, space, step) => splits.map((value) => value.toFixed(decimals(step))),
  ...extra,
});
// Width of a y axis, pixels: the same for all plots, unless a figure needs more.
const width_of_figures = (u, texts) => 18 + 7 * Math.max(6, ...(texts || []).map((text) => (text || "").length));

// A range with 6 % of space above and below; -1 to 1 if there are no values.
const spaced = (min, max) => {
  if (min == null) return [-1, 1];
  const spare = 0.06 * (max - min) || 0.1 * Math.abs(max) || 1;
  return [min - spare, max + spare];
};

// The visible bands of the x axis with their edges in canvas pixels.
const bands_in_view = (u, bands) =>
  bands
    .map((band) => ({
      ...band,
      left: Math.max(u.bbox.left, u.valToPos(band.from, "x", true)),
      right: Math.min(u.bbox.left + u.bbox.width, u.valToPos(band.to, "x", true)),
    }))
    .filter(({ left, right }) => left < right);

// Shades the bands that have a colour. Returns their number.
const shade_bands = (u, bands, opacity) => {
  const shaded = bands_in_view(u, bands).filter((band) => band.colour);
  u.ctx.save();
  shaded.forEach(({ left, right, colour: name }) => {
    u.ctx.fillStyle = colour(name, opacity);
    u.ctx.fillRect(left, u.bbox.top, right - left, u.bbox.height);
  });
  u.ctx.restore();
  return shaded.length;
};

// Writes the names of bands that are wide enough: the whole name, or without its first word ("-40" of
// "soak -40"). Returns the number of names written.
const name_bands = (u, bands) => {
  const pen = u.ctx;
  let named = 0;
  pen.save();
  pen.font = figures(11 * devicePixelRatio);
  pen.textAlign = "center";
  pen.textBaseline = "top";
  pen.lineWidth = 3 * devicePixelRatio;
  pen.strokeStyle = colour("paper", 0.8);
  pen.fillStyle = colour("faint");
  bands_in_view(u, bands).forEach(({ left, right, label }) => {
    const room = right - left - 4 * devicePixelRatio;
    const name = [label, label.split(" ").slice(1).join(" ")].find(
      (text) => text && pen.measureText(text).width <= room,
    );
    if (!name) return;
    const place = [name, (left + right) / 2, u.bbox.top + 3 * devicePixelRatio];
    pen.strokeText(...place);
    pen.fillText(...place);
    ++named;
  });
  pen.restore();
  return named;
};

// Calls paint(pen), clipped to the area within the axes.
const clipped = (u, paint) => {
  const pen = u.ctx;
  pen.save();
  pen.beginPath();
  pen.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
  pen.clip();
  pen.lineWidth = devicePixelRatio;
  pen.setLineDash([]);
  paint(pen);
  pen.restore();
};

// Draws an error bar from low to high.
const sigma_bar = (u, at, low, high) => {
  const x = u.valToPos(at, "x", true);
  u.ctx.beginPath();
  u.ctx.moveTo(x, u.valToPos(low, "y", true));
  u.ctx.lineTo(x, u.valToPos(high, "y", true));
  u.ctx.stroke();
};

// Draws dashed horizontal lines with their names.
const draw_levels = (u, levels) =>
  clipped(u, (pen) => {
    const { left, width } = u.bbox;
    pen.font = figures(12 * devicePixelRatio);
    pen.textAlign = "right";
    pen.textBaseline = "bottom";
    pen.strokeStyle = pen.fillStyle = colour("mark");
    pen.setLineDash([2 * devicePixelRatio, 3 * devicePixelRatio]);
    levels.forEach(({ y: value, label = "" }) => {
      const y = u.valToPos(value, "y", true);
      pen.beginPath();
      pen.moveTo(left, y);
      pen.lineTo(left + width, y);
      pen.stroke();
      pen.fillText(label, left + width - 4 * devicePixelRatio, y - 2 * devicePixelRatio);
    });
  });
