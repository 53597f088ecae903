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
new ResizeObserver(() => all_plots.forEach((plot) => plot.resize())).observe(document.body);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => all_plots.forEach((plot) => plot.redraw()));

// A plot of the rows of a run in the element `holder`, `height` CSS pixels high. show() takes the data
// and the options label (x axis), group (shared cursor), range, series, under and over (paint before
// and after the curves) and selected (called at the end of a drag).
class Plot {
  constructor(holder, height) {
    this.holder = holder;
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
    const shape = JSON.stringify([options.label, data.length]);
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

// Draws a point for each row in the colour of its branch, of more than max_points rows every second,
// third, ...
const max_points = 20000;
const cloud = (u, x, y, colours, size) =>
  clipped(u, (pen) => {
    const side = size * devicePixelRatio;
    const step = Math.ceil(x.length / max_points);
    for (const [kind, fill] of Object.entries(colours)) {
      pen.fillStyle = fill;
      for (let i = 0; i < x.length; i += step) {
        if (y.kind[i] !== Number(kind) || !isFinite(y.value[i])) continue;
        pen.fillRect(u.valToPos(x[i], "x", true) - side / 2, u.valToPos(y.value[i], "y", true) - side / 2, side, side);
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

// Columns for uPlot, time in hours; a row of nulls breaks the curves at each gap.
const with_gaps = (run, names) => {
  const x = [];
  const columns = names.map(() => []);
  run.time_s.forEach((time, i) => {
    if (i > 0 && run.gap_before[i]) {
      x.push((run.time_s[i - 1] + time) / 7200);
      columns.forEach((column) => column.push(null));
    }
    x.push(time / 3600);
    names.forEach((name, c) => columns[c].push(run[name] && !run.outlier[i] ? run[name][i] : null));
  });
  return [x, ...columns];
};

const plots = {
  rate: new Plot(byId("rate_plot"), 210),
  residual: new Plot(byId("residual_plot"), 230),
  variable: new Plot(byId("variable_plot"), 300),
};

// Masks as bands of the plots over time.
const bands_of = (masks) =>
  masks.map(([from, to]) => ({ from: from / 3600, to: to / 3600, colour: "measured", label: "" }));

const draw_run = (view, run, variable, masks, selected) => {
  const facts = view.runs[run];
  const values = view.values[run];
  const compared = view.compare.runs[run];
  const floor = compared.noise_floor_dph;
  const under = (u) => {
    shade_bands(u, facts.bands, 0.1);
    shade_bands(u, bands_of(masks), 0.3);
  };
  const names = (u) => name_bands(u, facts.bands);
  plots.rate.show(
    {
      label: "time since power-on, h",
      group: "time",
      range: spaced,
      under,
      over: names,
      series: [curve("measured", { width: 1.5 }), curve("model", { width: 1.5 })],
    },
    with_gaps(values, ["measured_dph", "modelled_dph"]),
  );
  plots.residual.show(
    {
      label: "time since power-on, h",
      group: "time",
      range: spaced,
      under,
      selected,
      over: (u) => {
        draw_levels(u, floor ? [{ y: -floor }, { y: floor }] : []);
        names(u);
      },
      series: [curve("residual", { width: 1 }), curve("model", { width: 1.75, dash: [6, 4] })],
    },
    with_gaps(values, ["residual_dph", "preview"]),
  );
  draw_variable(view, run, variable);
};

const draw_variable = (view, run, variable) => {
  const values = view.values[run];
  const { name, label } = view.runs[run].variables.find((one) => one.name === variable) || view.runs[run].variables[0];
  const x = values[name];
  const bins = (view.compare.runs[run].structure || {})[name];
  const ends = [Infinity, -Infinity];
  x.forEach((value) => {
    ends[0] = Math.min(ends[0], value);
    ends[1] = Math.max(ends[1], value);
  });
  const residual = {
    value: values.residual_dph.map((value, i) => (values.outlier[i] ? NaN : value)),
    kind: values.branch,
  };
  const limits = [Infinity, -Infinity];
  residual.value.forEach((value) => {
    if (!isFinite(value)) return;
    limits[0] = Math.min(limits[0], value);
    limits[1] = Math.max(limits[1], value);
  });
  plots.variable.show(
    {
      label,
      range: spaced,
      over: (u) => {
        cloud(
          u,
          x,
          residual,
          { 2: colour("measured", 0.5), 0: colour("heating", 0.55), 1: colour("cooling", 0.55) },
          2,
        );
        if (values.preview)
          cloud(
            u,
            x,
            { value: values.preview, kind: values.branch },
            { 2: colour("mark"), 0: colour("mark"), 1: colour("mark") },
            1.5,
          );
        if (bins) means(u, bins);
      },
      series: [{ points: { show: false }, width: 0 }],
    },
    [[ends[0], ends[1]], limits],
  );
};
