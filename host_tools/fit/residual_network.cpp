#include "fit/residual_network.hpp"

#include "fit/cross_validation.hpp"
#include "noise/whitening.hpp"

namespace fogcomp::fit {

ResidualNetwork train_on_residual(const series::Rows& rows, const Eigen::MatrixXd& inputs,
                                  const Eigen::VectorXd& target_dph,
                                  const Identification& identified,
                                  const network::NetworkSettings& settings, bool judge) {
  const double trainings = judge ? 1 + static_cast<double>(kPartsInTurn) : 1;
  double done_before = 0;
  network::NetworkSettings training = settings;
  if (settings.training.go_on) {
    training.training.go_on = [&](double done) {
      return settings.training.go_on((done_before + done) / trainings);
    };
  }
  const auto train = [&](const Eigen::VectorXd& weights) {
    const noise::Whitening whitening(identified.noise, rows, weights);
    const network::Whiten whiten = [&](const Eigen::MatrixXd& values) {
      return whitening.apply(values);
    };
    network::TrainedNetwork trained =
        network::train_network({inputs, target_dph, weights, rows.run_starts, whiten}, training);
    ++done_before;
    return trained;
  };

  ResidualNetwork network{train(identified.row_weights), std::nullopt};
  if (!judge || network.trained.result.interrupted) return network;
  bool interrupted = false;
  const auto learn = [&](const Eigen::VectorXd& weights) {
    const network::TrainedNetwork trained = train(weights);
    interrupted = interrupted || trained.result.interrupted;
    return trained.drift_dph(inputs);
  };
  const OutOfSample judged = cross_validate_learner(
      rows, identified.residual_dph, {identified.noise, identified.row_weights, false}, learn);
  if (!interrupted) network.judged = judged;
  return network;
}

}  // namespace fogcomp::fit
