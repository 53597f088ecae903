// Levenberg-Marquardt on beta * sum e^2 + alpha * sum w^2. MacKay's evidence rules re-estimate
// alpha and beta after every step (Foresee & Hagan, ICNN 1997), so that the weights of a network
// with nothing to learn go to zero. Rows with slow noise must be whitened: otherwise it would be
// learnt.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "network/trainer.hpp"
#include "network/trainer_parts.hpp"
#include "support/decompositions.hpp"

namespace fogcomp::network {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kMinDamping = 1e-12;
constexpr double kMaxDamping = 1e12;
constexpr double kSmallFall = 1e-7;  // relative fall of the cost in a step
// Steps without a better held-out error. Large, because alpha and beta settle in the middle of a
// training, and only then the held-out error falls again.
constexpr int kStepsWithoutGain = 60;
constexpr int kMaxIterations = 200;
constexpr int kStarts = 3;  // initial weights; the cost has many minima
// Initial alpha, in variances of an error. The evidence finds the maximum near its start: from a
// small value that of a network which has learnt noise, from a ten times larger one no network at
// all.
constexpr double kFirstPrice = 10;
constexpr double kVarianceGuessed = 1e-3;  // of a normalised error, if unknown

// alpha, beta and the effective number of weights. A common factor of alpha and beta is free; it is
// chosen so that beta is 1.
struct Evidence {
  double rows;          // with a weight above 0
  double min_variance;  // of an error
  double variance;      // of an error
  double alpha;
  double gamma = 0;

  Evidence(const VectorXd& errors, bool whitened)
      : rows(static_cast<double>((errors.array() != 0).count())),
        min_variance(whitened ? 1 : 0),
        variance(whitened ? 1 : kVarianceGuessed),
        alpha(kFirstPrice * variance) {}

  double cost(const VectorXd& errors, const VectorXd& w) const {
    return errors.squaredNorm() + alpha * w.squaredNorm();
  }
  void update(const MatrixXd& normal, const VectorXd& errors, const VectorXd& w) {
    const auto size = static_cast<double>(w.size());
    MatrixXd hessian = normal;
    hessian.diagonal().array() += alpha;
    const MatrixXd inverse = inverse_of_definite(hessian);
    gamma = std::clamp(size - alpha * inverse.trace(), 0.0, size);
    // Errors above the noise are what this network cannot learn: noise to it.
    variance = std::max({errors.squaredNorm() / std::max(rows - gamma, 1.0), min_variance, 1e-12});
    alpha = variance * gamma / std::max(w.squaredNorm(), 1e-12);
  }
  // MacKay's log evidence of a network with weights `w`, up to a constant.
  double logarithm(const MatrixXd& normal, const VectorXd& errors, const VectorXd& w) const {
    MatrixXd hessian = normal;
    hessian.diagonal().array() += alpha;
    const VectorXd root = cholesky_factor(hessian).diagonal();
    return -cost(errors, w) / (2 * variance) - root.array().log().sum() +
           (static_cast<double>(w.size()) * std::log(std::max(alpha, 1e-300)) -
            rows * std::log(variance)) /
               2;
  }
};

struct Start {
  TrainerResult result;
  double score = 0;  // by the held-out rows, else by the evidence
};

// State of the training.
struct State {
  VectorXd w;
  VectorXd errors;
  MatrixXd jacobian;
  MatrixXd normal;
  double damping = 1;

  void look(const TrainingProblem& problem) {
    problem.rows->errors(problem.shape, w, errors, &jacobian);
    normal = gram(jacobian);
  }
};

// One step with enough damping to lower the cost. Returns the decrease; 0 if there is none.
double step(const TrainingProblem& problem, const Evidence& evidence, State& state) {
  const double cost = evidence.cost(state.errors, state.w);
  const VectorXd gradient = state.jacobian.transpose() * state.errors + evidence.alpha * state.w;
  for (; state.damping <= kMaxDamping; state.damping *= 10) {
    MatrixXd system = state.normal;
    system.diagonal().array() += evidence.alpha + state.damping;
    const VectorXd tried = state.w - solve_definite(system, gradient);
    VectorXd tried_errors;
    problem.rows->errors(problem.shape, tried, tried_errors, nullptr);
    const double fall = cost - evidence.cost(tried_errors, tried);
    if (fall <= 0) continue;
    state.w = tried;
    state.damping = std::max(state.damping / 10, kMinDamping);
    return fall;
  }
  return 0;
}

Start train_from(const TrainingProblem& problem, const TrainerSettings& settings, int start) {
  const Perceptron& shape = problem.shape;
  const TrainingRows& rows = *problem.rows;
  State state;
  state.w = shape.first_weights(settings.seed * kStarts + static_cast<std::uint64_t>(start));
  state.look(problem);
  Evidence evidence(state.errors, rows.whitens());
  BestWeights best(problem, kStepsWithoutGain);
  const auto offer = [&] { best.offer(state.w, rows.mean_square(shape, state.w)); };
  if (problem.held_out != nullptr) offer();
  TrainerResult result;
  const int max_steps = std::min(settings.epochs, kMaxIterations);
  for (; result.epochs < max_steps; ++result.epochs) {
    result.stopped_early = best.exhausted();
    result.interrupted =
        settings.go_on &&
        !settings.go_on((start + static_cast<double>(result.epochs) / max_steps) / kStarts);
    if (result.stopped_early || result.interrupted) break;
    const double cost = evidence.cost(state.errors, state.w);
    const double fall = step(problem, evidence, state);
    if (fall <= 0) break;
    state.look(problem);
    evidence.update(state.normal, state.errors, state.w);
    if (problem.held_out != nullptr) offer();
    if (fall < kSmallFall * cost) break;
  }
  if (problem.held_out == nullptr) offer();
  result.weights = best.weights();
  result.mean_square = best.mean_square();
  result.effective_parameters = evidence.gamma;
  const double score = problem.held_out == nullptr
                           ? evidence.logarithm(state.normal, state.errors, state.w)
                           : -problem.held_out->mean_square(shape, result.weights);
  return {result, score};
}

}  // namespace

TrainerResult train_levenberg_marquardt(const TrainingProblem& problem,
                                        const TrainerSettings& settings) {
  Start best;
  for (int start = 0; start < kStarts; ++start) {
    const Start tried = train_from(problem, settings, start);
    if (start == 0 || tried.score > best.score) best = tried;
    if (!tried.result.interrupted) continue;
    best.result.interrupted = true;
    break;
  }
  return best.result;
}

}  // namespace fogcomp::network
