// Draws the plots of a report with uPlot from the data in #plots (report/plot.hpp). Drag zooms, a
// double click shows all again, a click in the legend hides a curve; plots of one group share cursor
// and zoom in x.
"use strict";
(() => {
  const plots = JSON.parse(document.getElementById("plots").textContent);
  const root = document.documentElement;
  const printed_width = 680; // CSS pixels between the margins of A4 and of Letter
  const drawn = [];
  const groups = new Map(); // name -> the plots drawn

  // Plots of one group begin and end together, so that showing all means the same for each.
  const with_group = new Map();
  plots.filter((plot) => plot.group).forEach((plot) => {
    with_group.set(plot.group, [...(with_group.get(plot.group) || []), plot]);
  });
  with_group.forEach((members) => {
    const low = Math.min(...members.map((plot) => plot.x[0]));
    const high = Math.max(...members.map((plot) => plot.x[plot.x.length - 1]));
    members.forEach((plot) => {
      if (plot.x[0] > low) {
        plot.x.unshift(low);
        plot.curves.forEach((curve) => curve.y.unshift(null));
      }
      if (plot.x[plot.x.length - 1] < high) {
        plot.x.push(high);
        plot.curves.forEach((curve) => curve.y.push(null));
      }
    });
  });

  const colour = (name, opacity = 1) => {
    const hex = getComputedStyle(root).getPropertyValue("--" + name).trim();
    const byte = Math.round(255 * opacity).toString(16).padStart(2, "0");
    return opacity < 1 ? hex + byte : hex;
  };
  const significant = (value) => (value == null ? "" : String(Number(value.toPrecision(4))));
  const decimals = (step) => {
    let places = 0;
    while (places < 9 && Math.abs(step * 10 ** places - Math.round(step * 10 ** places)) > 1e-6) {
      ++places;
    }
    return places;
  };

  // The columns that uPlot wants: one x for all. Where curves have their own, every point has a row
  // for itself, as several may have the same x.
  const aligned = (plot) => {
    if (plot.curves.every((curve) => !curve.x)) return [plot.x, ...plot.curves.map((curve) => curve.y)];
    const points = plot.curves.flatMap((curve, c) =>
      (curve.x || plot.x).map((x, i) => ({ x, c, y: curve.y[i], sigma: curve.sigma && curve.sigma[i] })));
    points.sort((a, b) => a.x - b.x);
    const column = (c, value) => points.map((point) => (point.c === c ? value(point) : null));
    plot.curves.forEach((curve, c) => {
      if (curve.sigma) curve.sigma = column(c, (point) => point.sigma);
    });
    return [points.map((point) => point.x), ...plot.curves.map((curve, c) => column(c, (point) => point.y))];
  };

  // Positive parts upwards, negative ones downwards from zero, each on the one before. A part is
  // two curves then, and the one below is not named a second time.
  const stacked = (plot) => {
    const parts = plot.curves.filter((curve) => curve.look === "line");
    const lines = plot.curves.filter((curve) => curve.look !== "line");
    const zero = plot.x.map((x, i) => (parts[0].y[i] == null ? null : 0));
    const data = [plot.x, zero];
    const series = [{ label: "", hidden: true }];
    const bands = [];
    for (const sign of [1, -1]) {
      let below = zero;
      let below_index = 1;
      parts.forEach((part) => {
        const sum = below.map((base, i) =>
          (base == null || part.y[i] == null ? null : base + sign * Math.max(0, sign * part.y[i])));
        data.push(sum);
        series.push({
          label: part.label,
          stroke: () => colour(part.colour),
          width: 0.5,
          hidden: sign < 0,
          value: (u, v, s, i) => significant(i == null ? null : part.y[i]),
        });
        const index = data.length - 1;
        bands.push({ series: sign > 0 ? [index, below_index] : [below_index, index],
                     fill: () => colour(part.colour, 0.7) });
        below = sum;
        below_index = index;
      });
    }
    lines.forEach((line) => {
      data.push(line.y);
      series.push({ label: line.label, stroke: () => colour(line.colour), width: 1.5 });
    });
    return { data, series, bands };
  };

  const unstacked = (plot) => ({
    data: aligned(plot),
    bands: [],
    series: plot.curves.map((curve) => {
      const points = curve.look === "points" || curve.look === "cloud";
      const opacity = { cloud: 0.6, faint: 0.6 }[curve.look] || 1;
      return {
        label: curve.label,
        stroke: () => colour(curve.colour, opacity),
        width: 1.5,
        dash: curve.look === "dashed" ? [6, 4] : undefined,
        spanGaps: Boolean(curve.x),
        paths: points ? () => null : undefined,
        points: { show: points, size: curve.look === "cloud" ? 3 : 6, width: 0,
                  fill: () => colour(curve.colour, opacity) },
      };
    }),
  });

  // The segments of the x axis that are in view: their edges in canvas pixels.
  const bands_in_view = (u, plot) => plot.bands.map((band) => ({
    ...band,
    left: Math.max(u.bbox.left, u.valToPos(band.from, "x", true)),
    right: Math.min(u.bbox.left + u.bbox.width, u.valToPos(band.to, "x", true)),
  })).filter(({ left, right }) => left < right);

  // Behind everything. How many is left in the page for tests.
  const shade = (u, plot, holder) => {
    const shaded = bands_in_view(u, plot).filter((band) => band.colour);
    u.ctx.save();
    shaded.forEach(({ left, right, colour: name }) => {
      u.ctx.fillStyle = colour(name, 0.13);
      u.ctx.fillRect(left, u.bbox.top, right - left, u.bbox.height);
    });
    u.ctx.restore();
    holder.dataset.shaded = shaded.length;
  };
  // Before everything, where there is room: the whole name, or what comes behind its first word, as
  // "-40" of "soak -40".
  const name_bands = (u, plot, holder) => {
    const pen = u.ctx;
    let named = 0;
    pen.save();
    pen.font = `${11 * devicePixelRatio}px system-ui, sans-serif`;
    pen.textAlign = "center";
    pen.textBaseline = "top";
    pen.lineWidth = 3 * devicePixelRatio;
    pen.strokeStyle = colour("paper", 0.8);
    pen.fillStyle = colour("faint");
    bands_in_view(u, plot).forEach(({ left, right, label }) => {
      const room = right - left - 4 * devicePixelRatio;
      const name = [label, label.split(" ").slice(1).join(" ")]
        .find((text) => text && pen.measureText(text).width <= room);
      if (!name) return;
      const place = [name, (left + right) / 2, u.bbox.top + 3 * devicePixelRatio];
      pen.strokeText(...place);
      pen.fillText(...place);
      ++named;
    });
    pen.restore();
    holder.dataset.named = named;
  };
  const segment_at = (plot, x) => {
    const band = x == null ? undefined : plot.bands.find(({ from, to }) => x >= from && x < to);
    return band ? ` (${band.label})` : "";
  };

  // Standard deviations as vertical bars, levels as lines with their names.
  const annotate = (u, plot) => {
    const pen = u.ctx;
    const box = u.bbox;
    pen.save();
    pen.beginPath();
    pen.rect(box.left, box.top, box.width, box.height);
    pen.clip();
    pen.lineWidth = devicePixelRatio;
    pen.setLineDash([]);
    plot.curves.forEach((curve, c) => {
      if (!curve.sigma || !u.series[c + 1].show) return;
      pen.strokeStyle = colour(curve.colour);
      u.data[c + 1].forEach((y, i) => {
        if (y == null || curve.sigma[i] == null) return;
        const x = u.valToPos(u.data[0][i], "x", true);
        const low = u.scales.y.distr === 3 ? Math.max(y - curve.sigma[i], y / 1e3) : y - curve.sigma[i];
        pen.beginPath();
        pen.moveTo(x, u.valToPos(low, "y", true));
        pen.lineTo(x, u.valToPos(y + curve.sigma[i], "y", true));
        pen.stroke();
      });
    });
    pen.font = `${12 * devicePixelRatio}px system-ui, sans-serif`;
    pen.textAlign = "right";
    plot.levels.forEach((level) => {
      const y = u.valToPos(level.y, "y", true);
      pen.strokeStyle = pen.fillStyle = colour("mark");
      pen.setLineDash([2 * devicePixelRatio, 3 * devicePixelRatio]);
      pen.beginPath();
      pen.moveTo(box.left, y);
      pen.lineTo(box.left + box.width, y);
      pen.stroke();
      pen.fillText(level.label, box.left + box.width - 4 * devicePixelRatio, y - 4 * devicePixelRatio);
    });
    pen.restore();
  };

  // The nearest point of a curve, as clouds share their x with others.
  const nearest = (u, s, at) => {
    const column = u.data[s];
    for (let away = 0; away < column.length; ++away) {
      if (column[at - away] != null) return at - away;
      if (column[at + away] != null) return at + away;
    }
    return at;
  };

  const size_of = (holder, plot) => {
    const width = root.dataset.printing ? printed_width : holder.clientWidth;
    const square = plot.kind === "log_log" || plot.curves.some((curve) => curve.look === "cloud");
    return { width, height: Math.round(Math.min(square ? 400 : 280, Math.max(220, 0.7 * width))) };
  };

  const axis = (label, extra) => ({
    label,
    font: "12px system-ui, sans-serif",
    labelFont: "12px system-ui, sans-serif",
    labelSize: 20,
    stroke: () => colour("ink"),
    grid: { stroke: () => colour("rule"), width: 1 },
    ticks: { stroke: () => colour("rule"), width: 1, size: 5 },
    ...extra,
  });

  // uPlot colours the marks of its legend once only, and does not say what a click there does.
  const dress_legend = (u) => u.root.querySelectorAll(".u-legend .u-series").forEach((row, i) => {
    if (i === 0) return;
    row.title = "click: hide or show this curve";
    const stroke = u.series[i].stroke;
    if (stroke) row.querySelector(".u-marker").style.background = stroke();
  });

  const draw = (holder, plot) => {
    const log_y = plot.kind === "log_log";
    const log_x = log_y || plot.kind === "log_x";
    const { data, series, bands } = plot.kind === "stacked" ? stacked(plot) : unstacked(plot);
    const y_range = (u, low, high) => {
      if (low == null) return [0, 1];
      plot.levels.forEach((level) => {
        low = Math.min(low, level.y);
        high = Math.max(high, level.y);
      });
      const spare = 0.06 * (high - low) || 0.1 * Math.abs(high) || 1;
      return [low - spare, high + spare];
    };
    const values = (logarithmic) => (logarithmic ? (u, splits) => splits.map(significant)
      : (u, splits, a, space, step) => splits.map((v) => v.toFixed(decimals(step))));
    const named = (i) => (plot.names[i] ? `${plot.names[i]}: ` : "");
    const x_value = (self, v, s, i) => named(i) + significant(v) + segment_at(plot, v);
    const peers = groups.get(plot.group) || [];
    const u = new uPlot({
      ...size_of(holder, plot),
      scales: {
        x: { time: false, distr: log_x ? 3 : 1 },
        y: log_y ? { distr: 3 } : { range: y_range },
      },
      axes: [
        axis(plot.x_label, { values: values(log_x), size: 34 }),
        axis(plot.y_label, {
          values: values(log_y),
          // The same for plots below each other, unless a figure needs more.
          size: (self, texts) => 18 + 7 * Math.max(6, ...(texts || []).map((text) => (text || "").length)),
        }),
      ],
      series: [{ label: plot.x_label, value: x_value },
               ...series.map((one) => ({ value: (self, v) => significant(v), points: { show: false }, ...one }))],
      bands,
      cursor: {
        drag: { x: true, y: true, uni: 30 },
        sync: plot.group ? { key: plot.group, filters: { pub: (type) => type === "mousemove" || type === "mouseleave" } }
          : undefined,
        dataIdx: plot.curves.some((curve) => curve.x) ? nearest : undefined,
        points: { size: 7 },
      },
      hooks: {
        drawClear: [(self) => shade(self, plot, holder)],
        draw: [(self) => annotate(self, plot), (self) => name_bands(self, plot, holder)],
        // Only what the reader did spreads: the others then have the same range and stop there.
        setScale: [(self, key) => {
          if (key !== "x" || !self.ready) return;
          const { min, max } = self.scales.x;
          peers.forEach((peer) => {
            if (peer === self || (peer.scales.x.min === min && peer.scales.x.max === max)) return;
            peer.setScale("x", { min, max });
          });
        }],
        ready: [(self) => { self.ready = true; }],
      },
    }, data, holder);
    series.forEach((one, i) => {
      if (one.hidden) u.root.querySelectorAll(".u-legend .u-series")[i + 1].style.display = "none";
    });
    if (plot.group) {
      peers.push(u);
      groups.set(plot.group, peers);
    }
    dress_legend(u);
    holder.dataset.points = data.slice(1).flat().filter((y) => y !== null).length;
    drawn.push({ u, holder, plot });
  };

  const resize_all = () => drawn.forEach(({ u, holder, plot }) => {
    const size = size_of(holder, plot);
    if (size.width > 0 && (size.width !== u.width || size.height !== u.height)) u.setSize(size);
  });
  const redraw_all = () => drawn.forEach(({ u }) => {
    u.redraw(false, true);
    dress_legend(u);
  });
  const print = (on) => {
    if (on) root.dataset.printing = "yes";
    else delete root.dataset.printing;
    resize_all();
    redraw_all();
  };

  document.querySelectorAll(".canvas[data-plot]").forEach((holder) => draw(holder, plots[holder.dataset.plot]));
  new ResizeObserver(resize_all).observe(document.querySelector("main"));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw_all);
  addEventListener("beforeprint", () => print(true));
  addEventListener("afterprint", () => print(false));
})();
