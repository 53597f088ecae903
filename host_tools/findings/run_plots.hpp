#pragma once

#include <string>
#include <vector>

#include "compare/branches.hpp"
#include "compare/comparison.hpp"
#include "compare/dependence.hpp"
#include "findings/plot.hpp"
#include "recording/segments.hpp"

namespace fogcomp::findings {

/// A quantity over time, to be drawn.
struct Trace {
  Text label;
  std::string colour;
  const std::vector<double>& values;
  Look look = Look::line;
};

/// Time axis of a run that several plots share: cursor and zoom go together by `group`.
struct TimeAxis {
  const std::vector<double>& time_s;
  std::vector<std::size_t> stretch_starts;
  std::string group;
  std::vector<recording::Segment> segments;
};
/// Of a comparison, which must outlive it.
TimeAxis time_axis(const compare::Comparison& comparison, const std::string& group);
std::vector<std::size_t> starts_of(const std::vector<recording::RowRange>& stretches);

/// Segments of a run as parts of an axis of hours, ramps shaded.
std::vector<Band> bands_of(const std::vector<recording::Segment>& segments);

/// Traces over hours since power-on, the segments shaded; long ones as minimum and maximum of each
/// column.
Plot time_plot(const Text& title, const Text& y_label, const TimeAxis& axis,
               const std::vector<Trace>& traces);

/// The temperature, with its range and segments in words.
Plot temperature_plot(const TimeAxis& axis, const std::vector<double>& temperature_degc);

/// The same traces upon each other as areas, each less its mean, with their sum.
Plot stacked_plot(const Text& title, const Text& y_label, const TimeAxis& axis,
                  const std::vector<Trace>& traces);

/// One quantity over another as points, heating and cooling in two colours.
Plot branch_plot(const Text& title, const Text& x_label, const Text& y_label,
                 const std::vector<double>& x, const std::vector<double>& y,
                 const std::vector<compare::Branch>& branch);

/// Whether the temperature ever moved: else a plot over it has nothing to show.
bool ever_moves(const std::vector<compare::Branch>& branch);

/// The means of the residual's bins with their standard errors, to lie on a branch_plot().
Curve bin_means(const std::vector<compare::ResidualBin>& bins);

/// Means of heating and cooling branch on a plot over temperature, and in its caption how far they
/// lie apart where that is more than noise.
void add_loop(Plot& over_temperature, const compare::Loop& loop);

/// The colour of the i-th of several like things.
std::string part_colour(std::size_t i);

}  // namespace fogcomp::findings
