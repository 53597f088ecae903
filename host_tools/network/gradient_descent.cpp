#include "network/trainer_parts.hpp"

namespace fogcomp::network {
namespace {

constexpr double kRateUp = 1.05;       // lr_inc
constexpr double kRateDown = 0.7;      // lr_dec
constexpr double kMaxIncrease = 1.04;  // max_perf_inc
constexpr double kMomentum = 0.9;      // mc
constexpr double kMinGradient = 1e-5;  // min_grad
// MATLAB's max_fail is 6 epochs; longer here, because noise in the held-out rows changes slowly.
constexpr int kEpochsWithoutGain = 200;
constexpr int kEpochsPerReport = 50;

}  // namespace

TrainerResult descend(const TrainingProblem& problem, const TrainerSettings& settings,
                      const Eigen::VectorXd& first) {
  Eigen::VectorXd weights = first;
  Eigen::VectorXd gradient;
  double cost = problem.rows->mean_square(problem.shape, weights, gradient);
  BestWeights best(problem, kEpochsWithoutGain);
  best.offer(weights, cost);
  Eigen::VectorXd step = -settings.learning_rate * gradient;
  Eigen::VectorXd tried_gradient;
  double rate = settings.learning_rate;
  TrainerResult result;
  for (; result.epochs < settings.epochs; ++result.epochs) {
    if (cost <= settings.goal || gradient.norm() < kMinGradient) break;
    result.stopped_early = best.exhausted();
    result.interrupted = result.epochs % kEpochsPerReport == 0 && settings.go_on &&
                         !settings.go_on(static_cast<double>(result.epochs) / settings.epochs);
    if (result.stopped_early || result.interrupted) break;
    step = kMomentum * step - (1 - kMomentum) * rate * gradient;
    const Eigen::VectorXd tried = weights + step;
    const double tried_cost = problem.rows->mean_square(problem.shape, tried, tried_gradient);
    if (!(tried_cost <= kMaxIncrease * cost)) {
      rate *= kRateDown;
      step = -rate * gradient;
      continue;
    }
    if (tried_cost < cost) rate *= kRateUp;
    weights = tried;
    cost = tried_cost;
    gradient.swap(tried_gradient);
    best.offer(weights, cost);
  }
  result.weights = best.weights();
  result.mean_square = best.mean_square();
  return result;
}

TrainerResult train_gradient_descent(const TrainingProblem& problem,
                                     const TrainerSettings& settings) {
  return descend(problem, settings, problem.shape.first_weights(settings.seed));
}

}  // namespace fogcomp::network
