// The plots. Values come from the engine; here they are only drawn.
"use strict";
const root = document.documentElement;
const byId = (id) => document.getElementById(id);

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

const colour = (name, opacity = 1) => {
  const hex = getComputedStyle(root).getPropertyValue("--" + name).trim();
  return opacity < 1 ? hex + Math.round(255 * opacity).toString(16).padStart(2, "0") : hex;
};
const rms = (value) => (value == null ? "" : Math.abs(value) >= 1e-6 && Math.abs(value) < 1e4 ? value.toPrecision(4) : String(Number(value.toPrecision(4))));
const significant = (value, digits = 4) => (value == null || !isFinite(value) ? "" : String(Number(value.toPrecision(digits))));
const decimals = (step) => {
  let places = 0;
  while (places < 9 && Math.abs(step * 10 ** places - Math.round(step * 10 ** places)) > 1e-6) ++places;
  return places;
};

const axis = (extra) => ({
  font: "11px system-ui, sans-serif",
  labelFont: "12px system-ui, sans-serif",
  labelSize: 16,
  stroke: () => colour("faint"),
  grid: { stroke: () => colour("rule"), width: 1 },
  ticks: { stroke: () => colour("rule"), width: 1, size: 4 },
  values: (u, splits, a, space, step) => splits.map((value) => value.toFixed(decimals(step))),
  ...extra,
});
const axes = (label) => [
  axis({ label, size: 26 }),
  axis({ size: (u, texts) => 14 + 7 * Math.max(6, ...(texts || []).map((text) => (text || "").length)) }),
];

const all_plots = new Set();
new ResizeObserver(() => all_plots.forEach((plot) => plot.resize())).observe(document.body);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => all_plots.forEach((plot) => plot.redraw()));

// A plot over the rows of a run, in place of the one that stood in `holder`. `draw` paints before
// the curves (under) or after them (over), in canvas pixels.
class Plot {
  constructor(holder, height) {
    this.holder = holder;
    this.height = height;
    all_plots.add(this);
  }

  show(options, data) {
    const shape = JSON.stringify([options.label, data.length]);
    if (this.u && this.shape === shape) {
      const { min, max } = this.u.scales.x;
      const before = this.u.data[0];
      const zoomed = min > before[0] || max < before[before.length - 1];
      const same_run = before.length === data[0].length && before[0] === data[0][0];
      this.options = options;
      this.u.setData(data);
      if (zoomed && same_run) this.u.setScale("x", { min, max });
      return;
    }
    if (this.u) this.u.destroy();
    this.shape = shape;
    this.options = options;
    this.u = new uPlot({
      ...this.size(),
      scales: { x: { time: false }, y: { range: (u, min, max) => this.options.range(min, max) } },
      axes: axes(options.label),
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
    }, data, this.holder);
  }

  size() { return { width: this.holder.clientWidth, height: this.height }; }
  resize() {
    if (this.u && this.holder.clientWidth > 0 && this.holder.clientWidth !== this.u.width) this.u.setSize(this.size());
  }
  redraw() { if (this.u) this.u.redraw(false, true); }
}

// With some space above and below; around 0 where there is nothing.
const spaced = (min, max) => {
  if (min == null) return [-1, 1];
  const spare = 0.06 * (max - min) || 0.1 * Math.abs(max) || 1;
  return [min - spare, max + spare];
};

// The segments of a run that are in view, from edge to edge in canvas pixels.
const in_view = (u, segments) => segments.map((segment) => ({
  ...segment,
  left: Math.max(u.bbox.left, u.valToPos(segment.start_s / 3600, "x", true)),
  right: Math.min(u.bbox.left + u.bbox.width, u.valToPos(segment.end_s / 3600, "x", true)),
})).filter(({ left, right }) => left < right);

// Soaks stay white.
const shade_segments = (u, segments) => in_view(u, segments).filter(({ kind }) => kind !== "soak").forEach(({ kind, left, right }) => {
  u.ctx.fillStyle = colour(kind, 0.1);
  u.ctx.fillRect(left, u.bbox.top, right - left, u.bbox.height);
});

// Before everything else, where there is room: the whole name, or what comes behind its first word.
const name_segments = (u, segments) => {
  const pen = u.ctx;
  pen.save();
  pen.font = `${11 * devicePixelRatio}px system-ui, sans-serif`;
  pen.textAlign = "center";
  pen.textBaseline = "top";
  pen.lineWidth = 3 * devicePixelRatio;
  pen.strokeStyle = colour("paper", 0.8);
  pen.fillStyle = colour("faint");
  in_view(u, segments).forEach(({ name, left, right }) => {
    const short = name.split(" ").slice(1).join(" ");
    const fitting = [name, short].find((one) => one && pen.measureText(one).width <= right - left - 4 * devicePixelRatio);
    if (!fitting) return;
    const place = [fitting, (left + right) / 2, u.bbox.top + 3 * devicePixelRatio];
    pen.strokeText(...place);
    pen.fillText(...place);
  });
  pen.restore();
};

const levels = (u, values) => {
  const pen = u.ctx;
  pen.save();
  pen.strokeStyle = colour("mark", 0.6);
  pen.lineWidth = devicePixelRatio;
  pen.setLineDash([2 * devicePixelRatio, 3 * devicePixelRatio]);
  values.forEach((value) => {
    const y = u.valToPos(value, "y", true);
    if (y < u.bbox.top || y > u.bbox.top + u.bbox.height) return;
    pen.beginPath();
    pen.moveTo(u.bbox.left, y);
    pen.lineTo(u.bbox.left + u.bbox.width, y);
    pen.stroke();
  });
  pen.restore();
};

// A point for each row, in the colour of its branch; of many rows every second, third, ...
const most_points = 20000;
const cloud = (u, x, y, colours, size) => {
  const pen = u.ctx;
  const side = size * devicePixelRatio;
  const step = Math.ceil(x.length / most_points);
  pen.save();
  pen.beginPath();
  pen.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
  pen.clip();
  for (const [kind, fill] of Object.entries(colours)) {
    pen.fillStyle = fill;
    for (let i = 0; i < x.length; i += step) {
      if (y.kind[i] !== Number(kind) || !isFinite(y.value[i])) continue;
      pen.fillRect(u.valToPos(x[i], "x", true) - side / 2, u.valToPos(y.value[i], "y", true) - side / 2, side, side);
    }
  }
  pen.restore();
};

// Means of classes with their standard errors, as the engine has them.
const means = (u, bins) => {
  const pen = u.ctx;
  pen.save();
  pen.beginPath();
  pen.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
  pen.clip();
  pen.strokeStyle = colour("mark", 0.45);
  pen.fillStyle = colour("mark");
  pen.lineWidth = devicePixelRatio;
  bins.at.forEach((at, i) => {
    const x = u.valToPos(at, "x", true);
    const [low, middle, high] = [-1, 0, 1].map((sign) => u.valToPos(bins.mean_dph[i] + sign * bins.sigma_dph[i], "y", true));
    pen.beginPath();
    pen.moveTo(x, low);
    pen.lineTo(x, high);
    pen.stroke();
    pen.fillRect(x - 2.5 * devicePixelRatio, middle - 2.5 * devicePixelRatio, 5 * devicePixelRatio, 5 * devicePixelRatio);
  });
  pen.restore();
};

const curve = (name, more = {}) => ({ stroke: () => colour(name), width: 1.25, points: { show: false }, ...more });

// Broken where the run has a gap.
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

// What is masked.
const shade_masks = (u, masks) => {
  const pen = u.ctx;
  pen.save();
  pen.fillStyle = colour("measured", 0.3);
  masks.forEach(([from, to]) => {
    const left = Math.max(u.bbox.left, u.valToPos(from / 3600, "x", true));
    const right = Math.min(u.bbox.left + u.bbox.width, u.valToPos(to / 3600, "x", true));
    if (left < right) pen.fillRect(left, u.bbox.top, right - left, u.bbox.height);
  });
  pen.restore();
};

const draw_run = (view, run, variable, masks, selected) => {
  const facts = view.runs[run];
  const values = view.values[run];
  const compared = view.compare.runs[run];
  const floor = compared.noise_floor_dph;
  const under = (u) => {
    shade_segments(u, facts.segments);
    shade_masks(u, masks);
  };
  const names = (u) => name_segments(u, facts.segments);
  plots.rate.show({ label: "time since power-on, h", group: "time", range: spaced, under, over: names,
                    series: [curve("measured", { width: 1.5 }), curve("model", { width: 1.5 })] },
                  with_gaps(values, ["measured_dph", "modelled_dph"]));
  plots.residual.show({
    label: "time since power-on, h", group: "time", range: spaced, under, selected,
    over: (u) => {
      levels(u, floor ? [-floor, floor] : []);
      names(u);
    },
    series: [curve("residual", { width: 1 }), curve("model", { width: 1.75, dash: [6, 4] })],
  }, with_gaps(values, ["residual_dph", "preview"]));
  draw_variable(view, run, variable);
};

const draw_variable = (view, run, variable) => {
  const values = view.values[run];
  const { name, label } = view.runs[run].variables.find((one) => one.name === variable) || view.runs[run].variables[0];
  const x = values[name];
  const bins = (view.compare.runs[run].structure || {})[name];
  const ends = [Infinity, -Infinity];
  x.forEach((value) => { ends[0] = Math.min(ends[0], value); ends[1] = Math.max(ends[1], value); });
  const residual = { value: values.residual_dph.map((value, i) => (values.outlier[i] ? NaN : value)), kind: values.branch };
  const limits = [Infinity, -Infinity];
  residual.value.forEach((value) => {
    if (!isFinite(value)) return;
    limits[0] = Math.min(limits[0], value);
    limits[1] = Math.max(limits[1], value);
  });
  plots.variable.show({
    label, range: spaced,
    over: (u) => {
      cloud(u, x, residual, { 2: colour("measured", 0.5), 0: colour("heating", 0.55), 1: colour("cooling", 0.55) }, 2);
      if (values.preview) cloud(u, x, { value: values.preview, kind: values.branch }, { 2: colour("mark"), 0: colour("mark"), 1: colour("mark") }, 1.5);
      if (bins) means(u, bins);
    },
    series: [{ points: { show: false }, width: 0 }],
  }, [[ends[0], ends[1]], limits]);
};
