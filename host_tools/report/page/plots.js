// Draws the plots of a report with uPlot from the data in #plots (report/plots.hpp). Drag zooms, a
// double click shows all, a click in the legend hides a curve. Plots of one group share cursor and
// zoom in x.
"use strict";
// Draws a plot into an element; returns what takes it away again.
const draw_plot = (() => {
  const plots = JSON.parse(byId("plots").textContent);
  const printed_width = 680; // CSS pixels between the margins of A4 and of Letter
  const drawn = [];
  const groups = new Map(); // name -> the plots drawn

  // All plots of a group get the same ends in x, so that a double click shows the same range in each.
  const with_group = new Map();
  plots
    .filter((plot) => plot.group)
    .forEach((plot) => {
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

  // The columns that uPlot takes: one x for all curves. If curves have an x of their own, each point is
  // a row of its own, because several may have the same x.
  const aligned = (plot) => {
    if (plot.curves.every((curve) => !curve.x)) return [plot.x, ...plot.curves.map((curve) => curve.y)];
    const points = plot.curves.flatMap((curve, c) =>
      (curve.x || plot.x).map((x, i) => ({ x, c, y: curve.y[i], sigma: curve.sigma && curve.sigma[i] })),
    );
    points.sort((a, b) => a.x - b.x);
    const column = (c, value) => points.map((point) => (point.c === c ? value(point) : null));
    plot.curves.forEach((curve, c) => {
      if (curve.sigma) curve.sigma = column(c, (point) => point.sigma);
    });
    return [points.map((point) => point.x), ...plot.curves.map((curve, c) => column(c, (point) => point.y))];
  };

  // Stacks the parts of a model: positive values upwards, negative ones downwards from zero. Each part
  // becomes two curves, of which only the upper one is in the legend.
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
          base == null || part.y[i] == null ? null : base + sign * Math.max(0, sign * part.y[i]),
        );
        data.push(sum);
        series.push({
          label: part.label,
          stroke: () => colour(part.colour),
          width: 0.5,
          hidden: sign < 0,
          value: (u, v, s, i) => significant(i == null ? null : part.y[i]),
        });
        const index = data.length - 1;
        bands.push({
          series: sign > 0 ? [index, below_index] : [below_index, index],
          fill: () => colour(part.colour, 0.7),
        });
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
        points: {
          show: points,
          size: curve.look === "cloud" ? 3 : 6,
          width: 0,
          fill: () => colour(curve.colour, opacity),
        },
      };
    }),
  });

  const segment_at = (plot, x) => {
    const band = x == null ? undefined : plot.bands.find(({ from, to }) => x >= from && x < to);
    return band ? ` (${band.label})` : "";
  };

  // Draws standard deviations as error bars, and the levels.
  const annotate = (u, plot) => {
    clipped(u, (pen) =>
      plot.curves.forEach((curve, c) => {
        if (!curve.sigma || !u.series[c + 1].show) return;
        pen.strokeStyle = colour(curve.colour);
        u.data[c + 1].forEach((y, i) => {
          if (y == null || curve.sigma[i] == null) return;
          const low = u.scales.y.distr === 3 ? Math.max(y - curve.sigma[i], y / 1e3) : y - curve.sigma[i];
          sigma_bar(u, u.data[0][i], low, y + curve.sigma[i]);
        });
      }),
    );
    draw_levels(u, plot.levels);
  };

  // The ends of the error bars that are in view.
  const sigma_ends = (u, plot) => {
    const { min, max } = u.scales.x;
    return plot.curves.flatMap((curve, c) => {
      if (!curve.sigma || !u.series[c + 1].show) return [];
      return u.data[c + 1].flatMap((y, i) => {
        const x = u.data[0][i];
        if (y == null || curve.sigma[i] == null || x < (min ?? x) || x > (max ?? x)) return [];
        return [y - curve.sigma[i], y + curve.sigma[i]];
      });
    });
  };

  // Index of the nearest row in which curve `s` has a point.
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

  // Renews the colours of the legend's marks, which uPlot sets once only, and says what a click does.
  const dress_legend = (u) =>
    u.root.querySelectorAll(".u-legend .u-series").forEach((row, i) => {
      if (i === 0) return;
      row.title = "Click to hide or show this curve";
      const stroke = u.series[i].stroke;
      if (stroke) row.querySelector(".u-marker").style.background = stroke();
    });

  const draw = (holder, plot) => {
    const log_y = plot.kind === "log_log";
    const log_x = log_y || plot.kind === "log_x";
    const { data, series, bands } = plot.kind === "stacked" ? stacked(plot) : unstacked(plot);
    const y_range = (u, low, high) => {
      if (low == null) return spaced(low, high);
      const ends = [...plot.levels.map((level) => level.y), ...sigma_ends(u, plot)];
      return spaced(Math.min(low, ...ends), Math.max(high, ...ends));
    };
    const values = (logarithmic) =>
      logarithmic ? { values: (u, splits) => splits.map((value) => significant(value)) } : {};
    const counts = plot.curves.every((curve) => curve.y.every((y) => Number.isInteger(y ?? 0)));
    const named = (i) => (plot.names[i] ? `${plot.names[i]}: ` : "");
    const x_value = (self, v, s, i) => named(i) + significant(v) + segment_at(plot, v);
    const peers = groups.get(plot.group) || [];
    const u = new uPlot(
      {
        ...size_of(holder, plot),
        scales: {
          x: { time: false, distr: log_x ? 3 : 1 },
          y: log_y ? { distr: 3 } : { range: y_range },
        },
        axes: [
          axis(plot.x_label, { ...values(log_x), size: 34 }),
          axis(plot.y_label, {
            ...values(log_y),
            size: width_of_figures,
            ...(counts && !log_y ? { incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000] } : {}),
          }),
        ],
        series: [
          { label: plot.x_label, value: x_value },
          ...series.map((one) => ({ value: (self, v) => significant(v), points: { show: false }, ...one })),
        ],
        bands,
        cursor: {
          drag: { x: true, y: true, uni: 30 },
          sync: plot.group
            ? { key: plot.group, filters: { pub: (type) => type === "mousemove" || type === "mouseleave" } }
            : undefined,
          dataIdx: plot.curves.some((curve) => curve.x) ? nearest : undefined,
          points: { size: 7 },
        },
        hooks: {
          // Tests read the numbers of shaded and named bands from the page.
          drawClear: [
            (self) => {
              holder.dataset.shaded = shade_bands(self, plot.bands, 0.13);
            },
          ],
          draw: [
            (self) => annotate(self, plot),
            (self) => {
              holder.dataset.named = name_bands(self, plot.bands);
            },
          ],
          // Passes a zoom on to the group. A plot that has the range already does not pass it on again.
          setScale: [
            (self, key) => {
              if (key !== "x" || !self.ready) return;
              const { min, max } = self.scales.x;
              peers.forEach((peer) => {
                if (peer === self || (peer.scales.x.min === min && peer.scales.x.max === max)) return;
                peer.setScale("x", { min, max });
              });
            },
          ],
          ready: [
            (self) => {
              self.ready = true;
            },
          ],
        },
      },
      data,
      holder,
    );
    series.forEach((one, i) => {
      if (one.hidden) u.root.querySelectorAll(".u-legend .u-series")[i + 1].style.display = "none";
    });
    if (plot.group) {
      peers.push(u);
      groups.set(plot.group, peers);
    }
    dress_legend(u);
    holder.dataset.points = data
      .slice(1)
      .flat()
      .filter((y) => y !== null).length;
    const one = { u, holder, plot };
    drawn.push(one);
    return () => {
      drawn.splice(drawn.indexOf(one), 1);
      u.destroy();
    };
  };

  const resize_all = () =>
    drawn.forEach(({ u, holder, plot }) => {
      const size = size_of(holder, plot);
      if (size.width > 0 && (size.width !== u.width || size.height !== u.height)) u.setSize(size);
    });
  const redraw_all = () =>
    drawn.forEach(({ u }) => {
      u.redraw(false, true);
      dress_legend(u);
    });
  const print = (on) => {
    if (on) root.dataset.printing = "yes";
    else delete root.dataset.printing;
    resize_all();
    redraw_all();
  };

  document.querySelectorAll("#report .canvas").forEach((holder) => draw(holder, plots[holder.dataset.plot]));
  new ResizeObserver(resize_all).observe(document.body);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw_all);
  addEventListener("beforeprint", () => print(true));
  addEventListener("afterprint", () => print(false));
  return draw;
})();
