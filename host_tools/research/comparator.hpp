#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "series/signal_series.hpp"

namespace fogcomp::research {

/// A drift predictor of the literature, for comparison: fitted to the rows of one or more
/// recordings, then evaluated on any.
class Comparator {
 public:
  virtual ~Comparator() = default;
  /// `denoised_dph`: denoised drift of series.rows(). Predictors that weight by noise use the
  /// measured rows instead.
  virtual void fit(const series::SignalSeries& series, const Eigen::VectorXd& denoised_dph) = 0;
  /// Predicted drift per row, deg/h.
  virtual Eigen::VectorXd drift_dph(const series::SignalSeries& series) const = 0;
  /// Choices made by the fit, in a few words: "order 5".
  virtual std::string chosen() const { return ""; }
};

struct ComparatorSettings {
  std::uint64_t seed = 1;
  int hidden = 10;          ///< neurons of the networks for the whole drift, as in the paper
  int residual_hidden = 6;  ///< neurons of the network for the residual of effects
  int epochs = 5000;        ///< of backpropagation
  int iterations = 300;     ///< of swarm and population
  std::string effects;      ///< of models with effects, in the syntax of fit --effects
};

struct ComparatorEntry {
  const char* name;
  const char* inputs;  ///< its inputs
  std::unique_ptr<Comparator> (*make)(const ComparatorSettings&);
};

/// All comparators, simplest first.
const std::vector<ComparatorEntry>& comparators();
const ComparatorEntry& find_comparator(const std::string& name);

/// Rows x 1: degC. Rows x 2: degC and degC/min. Rows x 2: hours since power-on and degC.
Eigen::MatrixXd temperature_of(const series::Rows& rows);
Eigen::MatrixXd temperature_and_rate_of(const series::Rows& rows);
Eigen::MatrixXd time_and_temperature_of(const series::Rows& rows);

/// Predicts `test` rows after a fit to `train` rows (inputs, target; inputs).
using FitAndPredict = std::function<Eigen::VectorXd(
    const Eigen::MatrixXd& train, const Eigen::VectorXd& target, const Eigen::MatrixXd& test)>;

/// Rms error of predictions for rows that were left out: ten folds, each of every tenth stretch of
/// neighbouring rows (100 stretches), because single rows share noise and history with their
/// neighbours.
double cross_validated_rms(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& target,
                           const FitAndPredict& method);

/// The reference paper's networks: inputs (time, temperature), logsig hidden neurons, tansig
/// output, min-max normalisation of inputs and target; trained by traingdx (BP), pso-bp or ga-bp.
std::unique_ptr<Comparator> make_bp(const ComparatorSettings& settings);
std::unique_ptr<Comparator> make_pso_bp(const ComparatorSettings& settings);
std::unique_ptr<Comparator> make_ga_bp(const ComparatorSettings& settings);

/// Physical effects by `identify`, alone or with a network (temperature, temperature rate; lm) on
/// their residual, like `fogcomp fit`.
std::unique_ptr<Comparator> make_effects(const ComparatorSettings& settings);
std::unique_ptr<Comparator> make_effects_and_network(const ComparatorSettings& settings);

}  // namespace fogcomp::research
