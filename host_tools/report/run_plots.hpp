#pragma once

#include <string>
#include <vector>

#include "dataset/segments.hpp"
#include "evaluation/branches.hpp"
#include "report/plot.hpp"

namespace fogcomp::report {

/// A quantity over time, to be drawn.
struct Trace {
  std::string label;
  std::string colour;
  const std::vector<double>& values;
};

/// Time axis of a run that several plots share: cursor and zoom go together by `group`.
struct TimeAxis {
  const std::vector<double>& time_s;
  std::vector<std::size_t> stretch_starts;
  std::string group;
};
std::vector<std::size_t> starts_of(const std::vector<RowRange>& stretches);

/// Traces over hours since power-on; long ones as least and greatest of each column.
Plot time_plot(const std::string& title, const std::string& y_label, const TimeAxis& axis,
               const std::vector<Trace>& traces);

/// The same traces upon each other as areas, each less its mean, with their sum.
Plot stacked_plot(const std::string& title, const std::string& y_label, const TimeAxis& axis,
                  const std::vector<Trace>& traces);

/// One quantity over another, heating and cooling in two colours; without curves where the
/// temperature never moved. `row_s`: length of a row.
Plot branch_plot(const std::string& title, const std::string& x_label, const std::string& y_label,
                 const std::vector<double>& x, const std::vector<double>& y,
                 const std::vector<Branch>& branch, double row_s);

/// The colour of the i-th of several like things.
std::string part_colour(std::size_t i);

}  // namespace fogcomp::report
