#include "network/network_training.hpp"

#include <algorithm>
#include <optional>

#include "network/trainer.hpp"
#include "support/input_error.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::network {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kHeadRoom = 1.25;      // the largest target is 1/1.25 of tansig's range
constexpr double kMinHalfRange = 1e-3;  // for a constant input
constexpr double kMinAmplitude = 1e-9;  // deg/h

std::vector<TrainedNetwork::Input> min_max(const MatrixXd& inputs) {
  std::vector<TrainedNetwork::Input> scales;
  for (Index i = 0; i < inputs.cols(); ++i) {
    const double min = inputs.col(i).minCoeff();
    const double max = inputs.col(i).maxCoeff();
    scales.push_back({(min + max) / 2, std::max((max - min) / 2, kMinHalfRange)});
  }
  return scales;
}

MatrixXd normalised(const MatrixXd& rows, const std::vector<TrainedNetwork::Input>& scales) {
  MatrixXd values(rows.rows(), rows.cols());
  for (Index i = 0; i < rows.cols(); ++i) {
    const TrainedNetwork::Input& scale = scales[static_cast<std::size_t>(i)];
    values.col(i) = ((rows.col(i).array() - scale.centre) / scale.half_range).max(-1).min(1);
  }
  return values;
}

struct TargetScale {
  double centre_dph;
  double amplitude_dph;
};

TargetScale scale_of(const VectorXd& target, TargetScaling scaling) {
  if (scaling == TargetScaling::about_zero) {
    return {0, kHeadRoom * std::max(target.cwiseAbs().maxCoeff(), kMinAmplitude)};
  }
  const double min = target.minCoeff();
  const double max = target.maxCoeff();
  return {(min + max) / 2, std::max((max - min) / 2, kMinAmplitude)};
}

// Training rows: all but the last recording, which is held out if there are several.
Index trained_rows(const NetworkTask& task) {
  const auto last_run = static_cast<Index>(task.run_starts.back());
  const Index rows = task.weights.size();
  return last_run > 0 && task.weights.tail(rows - last_run).sum() > 0 ? last_run : rows;
}

// For targets divided by `amplitude_dph`.
Whiten whiten_normalised(const NetworkTask& task, double amplitude_dph) {
  if (!task.whiten) return {};
  return [&task, amplitude_dph](const MatrixXd& values) -> MatrixXd {
    return amplitude_dph * task.whiten(values);
  };
}

}  // namespace

const std::vector<Trainer>& trainers() {
  static const std::vector<Trainer> all{
      {"lm", "Levenberg-Marquardt, Bayesian", train_levenberg_marquardt},
      {"traingdx", "gradient descent", train_gradient_descent},
      {"pso-bp", "particle swarm, then traingdx", train_particle_swarm},
      {"ga-bp", "genetic algorithm, then traingdx", train_genetic},
  };
  return all;
}

std::vector<std::string> trainer_names() {
  std::vector<std::string> names;
  for (const Trainer& trainer : trainers()) names.emplace_back(trainer.name);
  return names;
}

const Trainer& find_trainer(const std::string& name) {
  const auto found = std::find_if(trainers().begin(), trainers().end(),
                                  [&](const Trainer& trainer) { return name == trainer.name; });
  if (found == trainers().end()) {
    throw InputError("trainer", "'" + name + "' is unknown; lm, traingdx, pso-bp or ga-bp");
  }
  return *found;
}

VectorXd TrainedNetwork::drift_dph(const MatrixXd& rows) const {
  const auto run = [](const model::RealLayer& layer, const MatrixXd& in) -> MatrixXd {
    MatrixXd sums = in * layer.weights.transpose();
    sums.rowwise() += layer.biases.transpose();
    return sums.unaryExpr([&](double x) { return model::activate(layer.activation, x); });
  };
  const VectorXd y = run(output, run(hidden, normalised(rows, inputs))).col(0);
  return (amplitude_dph * y).array() + centre_dph;
}

TrainedNetwork train_network(const NetworkTask& task, const NetworkSettings& settings) {
  TrainedNetwork network;
  network.inputs = min_max(task.inputs);
  const TargetScale scale = scale_of(task.target_dph, settings.scaling);
  network.centre_dph = scale.centre_dph;
  network.amplitude_dph = scale.amplitude_dph;

  const MatrixXd inputs = normalised(task.inputs, network.inputs);
  const VectorXd target = (task.target_dph.array() - network.centre_dph) / network.amplitude_dph;
  const Index rows = target.size();
  const Index trained = trained_rows(task);
  const Index rest = rows - trained;
  const TrainingRows batch(inputs.topRows(trained), target.head(trained),
                           task.weights.head(trained),
                           whiten_normalised(task, network.amplitude_dph));
  std::optional<TrainingRows> held_out;
  if (rest > 0) {
    held_out.emplace(inputs.bottomRows(rest), target.tail(rest), task.weights.tail(rest));
  }

  TrainingProblem problem;
  problem.shape = {inputs.cols(), settings.hidden, settings.hidden_activation,
                   settings.output_activation};
  problem.rows = &batch;
  problem.held_out = held_out ? &*held_out : nullptr;
  network.result = find_trainer(settings.trainer).train(problem, settings.training);
  if (network.result.weights.size() == 0) {
    throw InputError("--network",
                     "there are too few rows for it to learn anything; use a longer "
                     "recording or leave it out");
  }
  network.hidden = problem.shape.hidden_layer(network.result.weights);
  network.output = problem.shape.output_layer(network.result.weights);
  network.rms_before_dph = weighted_rms(task.target_dph, task.weights);
  network.rms_after_dph =
      weighted_rms(task.target_dph - network.drift_dph(task.inputs), task.weights);
  return network;
}

}  // namespace fogcomp::network
