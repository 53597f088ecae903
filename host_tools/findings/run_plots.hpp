#pragma once

#include <string>
#include <vector>

#include "compare/comparison.hpp"
#include "compare/dependence.hpp"
#include "findings/plot.hpp"
#include "noise/allan.hpp"
#include "noise/noise_coefficients.hpp"
#include "recording/segments.hpp"

namespace fogcomp::findings {

/// A quantity as a function of time, for a plot.
struct Trace {
  Text label;
  std::string colour;
  const std::vector<double>& values;
  Look look = Look::line;
};

/// Common time axis of several plots of a run; `group` links their cursor and zoom.
struct TimeAxis {
  const std::vector<double>& time_s;
  std::vector<std::size_t> stretch_starts;
  std::string group;
  std::vector<recording::Segment> segments;
};
/// Time axis of a comparison, which must outlive it.
TimeAxis time_axis(const compare::Comparison& comparison, const std::string& group);
std::vector<std::size_t> starts_of(const std::vector<recording::RowRange>& stretches);

/// Segments of a run as parts of an axis of hours, ramps shaded.
std::vector<Band> bands_of(const std::vector<recording::Segment>& segments);

/// Traces over hours since power-on, with shaded segments; long traces as minimum and maximum per
/// pixel column.
Plot time_plot(const Text& title, const Text& y_label, const TimeAxis& axis,
               const std::vector<Trace>& traces);

/// The temperature, with its range and segments in words.
Plot temperature_plot(const TimeAxis& axis, const std::vector<double>& temperature_degc);

/// The same traces stacked as areas, each less its mean, with their sum.
Plot stacked_plot(const Text& title, const Text& y_label, const TimeAxis& axis,
                  const std::vector<Trace>& traces);

/// One quantity as a function of another, as points; heating and cooling in two colours.
Plot branch_plot(const Text& title, const Text& x_label, const Text& y_label,
                 const std::vector<double>& x, const std::vector<double>& y,
                 const std::vector<compare::Branch>& branch);

/// Whether the temperature moved at all: otherwise a plot over it shows nothing.
bool ever_moves(const std::vector<compare::Branch>& branch);

/// Means of the residual's bins with standard errors, for a branch_plot().
Curve bin_means(const std::vector<compare::ResidualBin>& bins);

/// A plot over temperature with means of the heating and the cooling branch and, if significant,
/// their distance in its caption.
Plot with_loop(Plot over_temperature, const compare::Loop& loop);

/// Colour of the i-th of several similar curves.
std::string part_colour(std::size_t i);

/// An Allan deviation in deg/h, with its colour in the other plots.
struct AllanCurve {
  Text label;
  std::string colour;
  const std::vector<noise::AllanPoint>& points;
};

/// Allan deviations with their standard deviations; for the last one also the fitted slopes of IEEE
/// Std 952 that the data show, and their sum.
Plot allan_plot(const std::vector<AllanCurve>& curves, const noise::NoiseCoefficients& fitted);

}  // namespace fogcomp::findings
