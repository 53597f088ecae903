#pragma once

#include <Eigen/Core>
#include <cstdint>
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

}  // namespace fogcomp::research
