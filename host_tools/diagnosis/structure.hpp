#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "diagnosis/candidates.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "noise/whitening.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::diagnosis {

/// Projects out of whitened columns what a fitted model could describe: its coefficients, small
/// changes of its shape parameters, and errors of its terms: a sensor a little early or late,
/// layers with other lags, a formula that bends a little with temperature.
class Residualizer {
 public:
  Residualizer(const series::Rows& rows, const fit::NoiseWeightedFit& fit);

  /// Whitened, without the model; has a few more rows than the input, because prior knowledge acts
  /// like additional measurements.
  VisiblePart operator()(const Eigen::MatrixXd& regressors) const;
  /// Whitened residual of the model.
  const Eigen::VectorXd& residual() const { return residual_; }
  const noise::Whitening& whitening() const { return whitening_; }
  /// Possible errors of the model's terms, rows x any number, each of one standard deviation.
  const Eigen::MatrixXd& inexact() const { return inexact_; }
  /// Fall of the squares of `left`, any number of whitened residuals without the model, by a step
  /// at each row: one per row and residual. 0 where less than rules::kMinVisible of the step is
  /// visible. O(rows).
  Eigen::MatrixXd chi2_drops_of_steps(const series::Rows& rows, const Eigen::MatrixXd& left) const;

 private:
  Eigen::MatrixXd with_priors(const Eigen::MatrixXd& columns) const;
  Eigen::MatrixXd without_model(const Eigen::MatrixXd& columns) const;

  noise::Whitening whitening_;
  Eigen::MatrixXd inexact_;
  Eigen::Index priors_ = 0;  // rows of prior knowledge
  Eigen::MatrixXd basis_;    // orthonormal
  Eigen::VectorXd residual_;
};

/// Smooth functions of one variable of the drift, without physics. They show whether a residual has
/// structure that no catalogued effect explains, and on which variable it depends.
struct StructureGroup {
  std::string variable;     ///< "temperature_degc", "temperature_rate", "time_s", ...
  Eigen::MatrixXd columns;  ///< rows x any, neither whitened nor scaled
};

/// What follows the temperature late, or with play.
struct TemperatureHistory {
  double parameter = 0;  ///< time constant, s, of the lag; or radius, degC, of the play operator
  bool is_play = false;
};
inline constexpr std::array<TemperatureHistory, 8> kTemperatureHistories{
    {{240}, {960}, {3840}, {15360}, {2, true}, {5, true}, {10, true}, {20, true}}};

/// How far the temperature of each row is from that, degC.
Eigen::VectorXd temperature_beyond(const series::Rows& rows, const Eigen::VectorXd& temperature,
                                   const TemperatureHistory& history);

/// Smooth functions of the time within each run, rows x any.
Eigen::MatrixXd smooths_in_time(const series::Rows& rows);

/// Smooth functions of temperature, its rate, their product, history (lagged temperatures and play
/// operators), time within each run, and every further input that varies.
std::vector<StructureGroup> structure_groups(const series::Rows& rows);

/// Smooth structure with the model projected out: orthonormal whitened columns, by group and
/// together.
struct VisibleStructure {
  std::vector<std::string> variables;
  std::vector<Eigen::MatrixXf> groups;
  Eigen::MatrixXf all;
  std::vector<StructureGroup> raw;  ///< all groups, as they are
};
VisibleStructure visible_structure(const series::Rows& rows, const Residualizer& residualizer);

}  // namespace fogcomp::diagnosis
