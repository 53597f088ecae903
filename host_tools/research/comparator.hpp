#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "series/signal_series.hpp"

namespace fogcomp::research {

/// A way to predict drift, as the literature compares them. Fitted to the rows of one or more
/// recordings, then asked about any.
class Comparator {
 public:
  virtual ~Comparator() = default;
  /// `denoised_dph`: the drift of series.rows(), denoised. Those that weight by the noise take the
  /// rows as measured instead.
  virtual void fit(const series::SignalSeries& series, const Eigen::VectorXd& denoised_dph) = 0;
  /// deg/h per row.
  virtual Eigen::VectorXd drift_dph(const series::SignalSeries& series) const = 0;
  /// What the fit chose, in a few words: "order 5".
  virtual std::string chosen() const { return ""; }
};

struct ComparatorSettings {
  std::uint64_t seed = 1;
  int hidden = 10;          ///< neurons of the networks for the whole drift, as in the paper
  int residual_hidden = 6;  ///< of the network on what effects leave, which is less
  int epochs = 5000;        ///< of backpropagation
  int iterations = 300;     ///< of swarm and population
  std::string effects;      ///< of the models that have some, as fit --effects takes them
};

struct ComparatorEntry {
  const char* name;
  const char* inputs;  ///< what it predicts from
  std::unique_ptr<Comparator> (*make)(const ComparatorSettings&);
};

/// All of them, simplest first.
const std::vector<ComparatorEntry>& comparators();
const ComparatorEntry& find_comparator(const std::string& name);

/// Rows x 1: degC. Rows x 2: degC and degC/min. Rows x 2: hours since power-on and degC.
Eigen::MatrixXd temperature_of(const series::Rows& rows);
Eigen::MatrixXd temperature_and_rate_of(const series::Rows& rows);
Eigen::MatrixXd time_and_temperature_of(const series::Rows& rows);

}  // namespace fogcomp::research
