#include "report/run_plots.hpp"

#include <cmath>
#include <numeric>

#include "report/thinning.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::report {
namespace {

constexpr const char* kTimeLabel = "time since power-on, h";

std::vector<const std::vector<double>*> columns_of(const std::vector<Trace>& traces) {
  std::vector<const std::vector<double>*> columns;
  for (const Trace& trace : traces) columns.push_back(&trace.values);
  return columns;
}

Plot plot_over_time(const std::string& title, const std::string& y_label, const TimeAxis& axis,
                    const std::vector<double>& time_s) {
  Plot plot;
  plot.title = title;
  plot.x_label = kTimeLabel;
  plot.y_label = y_label;
  plot.group = axis.group;
  for (const double time : time_s) plot.x.push_back(time / kSecondsPerHour);
  return plot;
}

std::string thinned_words(const TimeAxis& axis, std::size_t points, const char* how) {
  if (points >= axis.time_s.size()) return "";
  return format("Of %zu rows, %s in each of %zu columns.", axis.time_s.size(), how, kColumns);
}

}  // namespace

std::vector<std::size_t> starts_of(const std::vector<RowRange>& stretches) {
  std::vector<std::size_t> starts;
  for (const RowRange& stretch : stretches) starts.push_back(stretch.first);
  return starts;
}

std::string part_colour(std::size_t i) {
  constexpr std::size_t kColours = 8;
  return format("part%zu", i % kColours + 1);
}

Plot time_plot(const std::string& title, const std::string& y_label, const TimeAxis& axis,
               const std::vector<Trace>& traces) {
  Curves curves = least_and_greatest(axis.time_s, columns_of(traces), axis.stretch_starts);
  Plot plot = plot_over_time(title, y_label, axis, curves.x);
  plot.caption = thinned_words(axis, curves.x.size(), "the least and the greatest");
  for (std::size_t i = 0; i < traces.size(); ++i) {
    plot.curves.push_back({traces[i].label, traces[i].colour, std::move(curves.y[i])});
  }
  return plot;
}

Plot stacked_plot(const std::string& title, const std::string& y_label, const TimeAxis& axis,
                  const std::vector<Trace>& traces) {
  Curves curves = column_means(axis.time_s, columns_of(traces), axis.stretch_starts);
  Plot plot = plot_over_time(title, y_label, axis, curves.x);
  plot.kind = Plot::Kind::stacked;
  plot.caption =
      "Each less its mean over the run. " + thinned_words(axis, curves.x.size(), "the mean");
  std::vector<double> sum(curves.x.size());
  for (std::size_t i = 0; i < traces.size(); ++i) {
    const std::vector<double>& all = traces[i].values;
    const double mean =
        std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
    for (std::size_t row = 0; row < sum.size(); ++row) {
      curves.y[i][row] -= mean;
      sum[row] += curves.y[i][row];
    }
    plot.curves.push_back({traces[i].label, traces[i].colour, std::move(curves.y[i])});
  }
  plot.curves.push_back({"all together", "mark", std::move(sum), {}, {}, Look::dashed});
  return plot;
}

Plot branch_plot(const std::string& title, const std::string& x_label, const std::string& y_label,
                 const std::vector<double>& x, const std::vector<double>& y,
                 const std::vector<Branch>& branch, double row_s) {
  const std::size_t per_point = rows_per_point(x.size());
  Plot plot;
  plot.title = title;
  plot.x_label = x_label;
  plot.y_label = y_label;
  plot.caption = "Soaks count with the ramp before them.";
  plot.caption +=
      format(" Each point is the mean of %.4g s.", static_cast<double>(per_point) * row_s);
  const auto add = [&](const char* label, const char* colour, Branch wanted) {
    Cloud cloud = thinned(x, y, branch, wanted, per_point);
    if (cloud.x.empty()) return;
    plot.curves.push_back({label, colour, std::move(cloud.y), std::move(cloud.x), {}, Look::cloud});
  };
  add("heating", "heating", Branch::heating);
  add("cooling", "cooling", Branch::cooling);
  if (plot.curves.empty()) return plot;
  add("before the first movement", "measured", Branch::none);
  return plot;
}

}  // namespace fogcomp::report
