#pragma once

#include <optional>
#include <vector>

#include "compare/comparison.hpp"
#include "compare/dependence.hpp"
#include "noise/allan.hpp"

namespace fogcomp::compare {

struct LagCorrelation {
  double lag_s = 0;
  double correlation = 0;  ///< -1..1
};

/// What is left in the residual of a run, and on what it depends.
struct ResidualAnalysis {
  /// rms^2 - floor^2, (deg/h)^2: what a better model could remove. Nothing if it is within four
  /// standard errors of the floor's estimate (0.6/sqrt(rows), relative), or no floor is known.
  std::optional<double> excess_dph2;
  double offset_sigma_dph = 0;     ///< standard error of the residual's mean
  ClassTest offset;                ///< of the mean against 0: turn-on bias, ageing between runs
  Dependence temperature;          ///< degC
  Dependence rate;                 ///< degC/min
  Dependence time;                 ///< s
  std::vector<Dependence> inputs;  ///< as Comparison::inputs
  /// Fraction of the residual's variance that errors of the input rate explain, of any form
  /// (noise::input_rate_columns); nothing if it is constant or the rows are too few.
  std::optional<double> input_rate_share;
  Loop history;
  std::vector<LagCorrelation> autocorrelation;
  double white_band = 0;  ///< +-2/sqrt(rows): where 95 % of them lie for white noise
  /// Only in soaks; empty if none is long enough. Same times and uncertainties for both.
  std::vector<noise::AllanPoint> raw_allan;
  std::vector<noise::AllanPoint> residual_allan;

  /// Fraction of the excess that a class test explains, 0..1; nothing if no excess is known.
  std::optional<double> share_of_excess(const ClassTest& test) const;
};

/// Four standard errors of a noise floor estimated from so many rows, relative to it.
double floor_uncertainty(std::size_t rows);

/// Shares of different variables overlap: in one chamber cycle temperature, rate, time and history
/// are correlated.
ResidualAnalysis analyse_residual(const Comparison& comparison);

}  // namespace fogcomp::compare
