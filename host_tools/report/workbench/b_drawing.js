// The workbench's three plots. All values come from the engine.
"use strict";
// An element with attributes, listeners ("onclick") and children.
const make = (tag, attributes = {}, ...children) => {
  const element = document.createElement(tag);
  Object.entries(attributes).forEach(([name, value]) => {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (name in element && name !== "list") element[name] = value;
    else element.setAttribute(name, value);
  });
  element.append(...children);
  return element;
};

// A rate with its significant digits, also if they are zeros.
const rms = (value, digits = 4) =>
  value == null
    ? ""
    : Math.abs(value) >= 1e-6 && Math.abs(value) < 10 ** digits
      ? value.toPrecision(digits)
      : String(Number(value.toPrecision(digits)));
const all_plots = new Set();
const resize_plots = () => all_plots.forEach((plot) => plot.resize());
new ResizeObserver(resize_plots).observe(document.body);
addEventListener("beforeprint", resize_plots);
addEventListener("afterprint", resize_plots);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => all_plots.forEach((plot) => plot.redraw()));

// A plot of the rows of a run in the element `holder`, `height` CSS pixels high. show() takes the data
// and the options label (x axis), group (shared cursor), range, series, under and over (paint before
// and after the curves), selected (called at the end of a drag), and read (what to say of the place under
// the cursor, or "").
class Plot {
  constructor(name, height) {
    const holder = byId(`${name}_plot`);
    this.holder = holder;
    this.said = byId(`${name}_read`);
    this.height = height;
    this.held = false; // whether the mouse button is down within the axes
    holder.addEventListener(
      "mousedown",
      ({ button }) => {
        this.held = button === 0;
      },
      true,
    );
    document.addEventListener("mouseup", () => {
      this.held = false;
    });
    all_plots.add(this);
  }

  show(options, data) {
    const shape = JSON.stringify([options.label, options.series.length]);
    if (this.u && this.shape === shape) {
      const { min, max } = this.u.scales.x;
      const before = this.u.data[0];
      const zoomed = min != null && (min > before[0] || max < before[before.length - 1]); // null before the first drawing
      const same_run = before.length === data[0].length && before[0] === data[0][0];
      this.options = options;
      this.u.setData(data);
      if (zoomed && same_run) this.u.setScale("x", { min, max });
      return;
    }
    if (this.u) this.u.destroy();
    this.shape = shape;
    this.options = options;
    this.u = new uPlot(
      {
        ...this.size(),
        scales: { x: { time: false }, y: { range: (u, min, max) => this.options.range(min, max) } },
        axes: [axis(options.label, { size: 34 }), axis(undefined, { size: width_of_figures })],
        series: [{}, ...options.series],
        legend: { show: false },
        cursor: {
          drag: { x: true, y: false, setScale: true },
          sync: options.group ? { key: options.group, scales: ["x", null] } : undefined,
          points: { show: false },
        },
        hooks: {
          drawClear: [(u) => this.options.under && this.options.under(u)],
          draw: [(u) => this.options.over && this.options.over(u)],
          setSelect: [(u) => this.options.selected && this.options.selected(u)],
          setCursor: [
            (u) => {
              this.said.textContent = u.cursor.left >= 0 ? this.options.read(u) : "";
            },
          ],
        },
      },
      data,
      this.holder,
    );
  }

  size() {
    return { width: this.holder.clientWidth, height: this.height };
  }
  resize() {
    if (this.u && this.holder.clientWidth > 0 && this.holder.clientWidth !== this.u.width) this.u.setSize(this.size());
  }
  // Cancels a drag until the mouse button is released. Returns whether there was one.
  cancel_drag() {
    if (!this.held) return false;
    const clear = () => this.u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    clear();
    this.holder.classList.add("cancelled");
    document.addEventListener(
      "mouseup",
      () => {
        clear();
        this.holder.classList.remove("cancelled");
      },
      { capture: true, once: true },
    );
    return true;
  }
  redraw() {
    if (this.u) this.u.redraw(false, true);
  }
}

// Canvas pixels of a value along a linear axis.
const pixels = (u, axis) => {
  const { min, max } = u.scales[axis];
  const begin = u.valToPos(min, axis, true);
  const scale = (u.valToPos(max, axis, true) - begin) / (max - min);
  return (value) => begin + scale * (value - min);
};

// Draws a point for each row in the colour of its branch, of more than max_points rows every second,
// third, ...
const max_points = 4000;
const cloud = (u, x, y, kinds, colours, size) =>
  clipped(u, (pen) => {
    const side = size * devicePixelRatio;
    const step = Math.ceil(x.length / max_points);
    const [across, up] = [pixels(u, "x"), pixels(u, "y")];
    for (const [kind, fill] of Object.entries(colours)) {
      pen.fillStyle = fill;
      for (let i = 0; i < x.length; i += step) {
        if (kinds[i] !== Number(kind) || !isFinite(y[i])) continue;
        pen.fillRect(across(x[i]) - side / 2, up(y[i]) - side / 2, side, side);
      }
    }
  });

// Draws the means of bins along x with their standard errors.
const means = (u, bins) =>
  clipped(u, (pen) => {
    const side = 5 * devicePixelRatio;
    pen.strokeStyle = colour("mark", 0.45);
    pen.fillStyle = colour("mark");
    bins.at.forEach((at, i) => {
      sigma_bar(u, at, bins.mean_dph[i] - bins.sigma_dph[i], bins.mean_dph[i] + bins.sigma_dph[i]);
      pen.fillRect(
        u.valToPos(at, "x", true) - side / 2,
        u.valToPos(bins.mean_dph[i], "y", true) - side / 2,
        side,
        side,
      );
    });
  });

const curve = (name, more = {}) => ({ stroke: () => colour(name), width: 1.25, points: { show: false }, ...more });

// Columns for uPlot, time in hours, and the row of each of their values; nulls break the curves at each gap.
const with_gaps = (run, names) => {
  const x = [];
  const rows = [];
  const columns = names.map(() => []);
  const { time_s, gap_before, outlier } = run;
  time_s.forEach((time, i) => {
    if (i > 0 && gap_before[i]) {
      x.push((time_s[i - 1] + time) / 7200);
      rows.push(i);
      columns.forEach((column) => column.push(null));
    }
    x.push(time / 3600);
    rows.push(i);
    names.forEach((name, c) => columns[c].push(run[name] && !outlier[i] ? run[name][i] : null));
  });
  return { rows, data: [x, ...columns] };
};

// A row in figures.
const row_words = (values, i) =>
  `${(values.time_s[i] / 3600).toFixed(3)} h, ${values.temperature_degc[i].toFixed(2)} °C, ` +
  `${significant(values.temperature_rate[i], 3)} °C/min: measured ${rms(values.measured_dph[i])}, ` +
  `model ${rms(values.modelled_dph[i])}, residual ${rms(values.residual_dph[i], 3)} °/h`;

const plots = {
  rate: new Plot("rate", 210),
  residual: new Plot("residual", 230),
  variable: new Plot("variable", 300),
};

// Masks as bands of the plots over time.
const bands_of = (masks) =>
  masks.map(([from, to]) => ({ from: from / 3600, to: to / 3600, colour: "measured", label: "" }));

// `masks` and `selected` of the residual; `before`: the residual of another state, or null.
const draw_run = (view, run, { masks, selected, before }) => {
  const facts = view.runs[run];
  const values = { ...view.values[run], before };
  const floor = view.compare.runs[run].noise_floor_dph;
  const under = (u) => {
    shade_bands(u, facts.bands, 0.1);
    shade_bands(u, bands_of(masks), 0.3);
  };
  const names = (u) => name_bands(u, facts.bands);
  const over_time = (plot, columns, options) => {
    const { rows, data } = with_gaps(values, columns);
    const read = (u) => (u.cursor.idx == null ? "" : row_words(values, rows[u.cursor.idx]));
    plot.show({ label: "time since power-on, h", group: "time", range: spaced, under, read, ...options }, data);
  };
  over_time(plots.rate, ["measured_dph", "modelled_dph"], {
    over: names,
    series: [curve("measured", { width: 1.5 }), curve("model", { width: 1.5 })],
  });
  over_time(plots.residual, ["before", "residual_dph", "preview"], {
    selected,
    over: (u) => {
      draw_levels(u, floor ? [{ y: -floor }, { y: floor }] : []);
      names(u);
    },
    series: [
      curve("measured", { width: 1 }),
      curve("residual", { width: 1 }),
      curve("model", { width: 1.75, dash: [6, 4] }),
    ],
  });
};

const ends_of = (values) => {
  const ends = [Infinity, -Infinity];
  values.forEach((value) => {
    if (!isFinite(value)) return;
    ends[0] = Math.min(ends[0], value);
    ends[1] = Math.max(ends[1], value);
  });
  return ends;
};

// The row drawn nearest to the cursor.
const nearest_row = (u, x, y) => {
  const [across, up] = [pixels(u, "x"), pixels(u, "y")];
  const [left, top] = [u.cursor.left, u.cursor.top].map((place) => place * devicePixelRatio);
  let [best, row] = [Infinity, -1];
  x.forEach((value, i) => {
    const away = Math.hypot(across(value) - u.bbox.left - left, up(y[i]) - u.bbox.top - top);
    if (away < best) [best, row] = [away, i];
  });
  return row;
};

// One quantity of the rows over another; with means and a preview where it is the residual.
const draw_variable = (view, run, over, of) => {
  const values = view.values[run];
  const is_residual = of === "residual_dph";
  const { label } = view.runs[run].variables.find(({ name }) => name === over);
  const x = values[over];
  const y = values[of].map((value, i) => (values.outlier[i] ? NaN : value));
  const bins = is_residual && (view.compare.runs[run].structure || {})[over];
  const kinds = values.branch;
  plots.variable.show(
    {
      label,
      range: spaced,
      over: (u) => {
        const colours = { 2: colour("measured", 0.5), 0: colour("heating", 0.55), 1: colour("cooling", 0.55) };
        cloud(u, x, y, kinds, colours, 2);
        const mark = colour("mark");
        if (is_residual && values.preview) cloud(u, x, values.preview, kinds, { 2: mark, 0: mark, 1: mark }, 1.5);
        if (bins && bins.mean_dph) means(u, bins);
      },
      read: (u) => {
        const row = nearest_row(u, x, y);
        return row < 0 ? "" : row_words(values, row);
      },
      series: [{ points: { show: false }, width: 0 }],
    },
    [ends_of(x), ends_of(y)],
  );
};

// The variable of which the residual depends most: by the diagnosis, where it names one of the axes, else as far as
// `compare` has judged it.
const strongest = ({ view, diagnosis }, run) => {
  const { variables } = view.runs[run];
  const named = diagnosis && variables.find(({ name }) => name === diagnosis.diagnosis.where.variable);
  if (named) return named.name;
  const structure = view.compare.runs[run].structure || {};
  const share = ({ name }) => ((structure[name] || {}).structured ? structure[name].share_of_excess : 0);
  return [...variables].sort((a, b) => share(b) - share(a))[0].name;
};
