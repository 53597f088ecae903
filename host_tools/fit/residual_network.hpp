#pragma once

#include <Eigen/Core>
#include <optional>

#include "fit/identify.hpp"
#include "fit/network_training.hpp"
#include "fit/out_of_sample.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// A network on what effects leave, and whether it was worth it.
struct ResidualNetwork {
  TrainedNetwork trained;
  /// Against the effects alone. Nothing where it was not asked for, or was interrupted.
  std::optional<OutOfSample> judged;

  /// A network that does not help where it was not trained has learnt noise, or what this run alone
  /// has.
  bool worth_keeping() const { return !judged || judged->helps(); }
};

/// Trains on `target_dph` (per row; what the effects of `identified` leave, or that denoised), its
/// rows whitened with the noise of that fit. `inputs`: rows x inputs, in their units. `judge`: the
/// network is trained five times more, each time without a fifth of the rows' stretches
/// (out_of_sample.hpp), and judged where it was not trained. Effects and the inputs' ranges stay
/// those of all rows.
ResidualNetwork train_on_residual(const series::Rows& rows, const Eigen::MatrixXd& inputs,
                                  const Eigen::VectorXd& target_dph,
                                  const Identification& identified, const NetworkSettings& settings,
                                  bool judge);

}  // namespace fogcomp::fit
