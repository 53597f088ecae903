#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/thermal/signals.hpp"
#include "identification/block_series.hpp"
#include "model/model.hpp"

namespace fogcomp {

/// The rows of a fit: means over `average_s` of what was measured and of what the effects would
/// give.
struct Design {
  Eigen::MatrixXd regressors;  ///< rows x all regressors of all terms, in the order of the terms
  Eigen::VectorXd drift_dph;   ///< measured rate - input rate
  Eigen::VectorXd weights;     ///< samples behind each row, relative to a full one
  std::vector<double> time_s;
  std::vector<fog::Signals<RealNumbers>> signals;  ///< means of temperature and its rate

  Eigen::Index rows() const { return drift_dph.size(); }
};

/// `model` gives the terms' shapes, the derivative's time constant and the averaging; its
/// coefficients do not matter. Temperature is not clamped: a fit has no trained range yet. Throws
/// InputError where the recording lacks what an effect needs.
Design make_design(const Model& model, const BlockSeries& series);

/// The designs of several recordings, one below the other.
Design join(const std::vector<Design>& parts);

/// Blocks that make one row of `average_s` seconds, at least one.
std::int64_t blocks_per_row(double average_s, double block_s);

}  // namespace fogcomp
