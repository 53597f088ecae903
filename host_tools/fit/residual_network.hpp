#pragma once

#include <Eigen/Core>
#include <optional>

#include "fit/cross_validation.hpp"
#include "fit/identify.hpp"
#include "network/network_training.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// A network on the residual of effects, and whether it helps.
struct ResidualNetwork {
  network::TrainedNetwork trained;
  /// Comparison with the effects alone. Nothing if not requested or interrupted.
  std::optional<OutOfSample> judged;

  /// A network that does not help out of sample has learnt noise, or a property of this run alone.
  bool worth_keeping() const { return !judged || helps(*judged); }
};

/// Trains on `target_dph` (per row; the residual of `identified`, or that denoised), whitened with
/// the noise of that fit. `inputs`: rows x inputs, in their units. `judge`: trains the network five
/// more times, each time without a fifth of the rows' stretches (cross_validation.hpp), and judges
/// it there. Effects and input ranges are those of all rows.
ResidualNetwork train_on_residual(const series::Rows& rows, const Eigen::MatrixXd& inputs,
                                  const Eigen::VectorXd& target_dph,
                                  const Identification& identified,
                                  const network::NetworkSettings& settings, bool judge);

}  // namespace fogcomp::fit
