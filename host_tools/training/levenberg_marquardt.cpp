// Levenberg-Marquardt on beta * sum e^2 + alpha * sum w^2, with alpha and beta re-estimated after
// every step by MacKay's evidence rules (Foresee & Hagan, ICNN 1997), so that a network with
// nothing to learn shrinks to nothing instead of learning noise.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "training/best_weights.hpp"
#include "training/trainer.hpp"

namespace fogcomp {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kLeastDamping = 1e-12;
constexpr double kMostDamping = 1e12;
constexpr double kConverged = 1e-7;  // relative fall of the cost in a step
// Steps without a better held-out error. Long, because the prices of error and of weights settle in
// the middle of a training, and the error on other runs falls again when they do.
constexpr int kStepsWithoutGain = 60;
constexpr int kMostSteps = 200;

MatrixXd normal_matrix(const MatrixXd& jacobian) {
  MatrixXd normal = MatrixXd::Zero(jacobian.cols(), jacobian.cols());
  normal.selfadjointView<Eigen::Lower>().rankUpdate(jacobian.transpose());
  return normal.selfadjointView<Eigen::Lower>();
}

// The prices of error and of weights, and how many weights the data determine. One common factor of
// the prices is free; it keeps that of errors at 1.
struct Evidence {
  double rows = 0;  // independent ones
  double alpha = 0.01;
  double gamma = 0;

  double cost(const VectorXd& errors, const VectorXd& w) const {
    return errors.squaredNorm() + alpha * w.squaredNorm();
  }
  void update(const MatrixXd& normal, const VectorXd& errors, const VectorXd& w) {
    const auto size = static_cast<double>(w.size());
    MatrixXd hessian = normal;
    hessian.diagonal().array() += alpha;
    const MatrixXd inverse =
        hessian.llt().solve(MatrixXd::Identity(hessian.rows(), hessian.cols()));
    gamma = std::clamp(size - alpha * inverse.trace(), 0.0, size);
    const double weight_price = gamma / (2 * std::max(w.squaredNorm(), 1e-12));
    const double error_price =
        std::max(rows - gamma, 1.0) / (2 * std::max(errors.squaredNorm(), 1e-12));
    alpha = weight_price / error_price;
  }
};

}  // namespace

TrainerResult train_levenberg_marquardt(const TrainingProblem& problem,
                                        const TrainerSettings& settings) {
  const Perceptron& shape = problem.shape;
  const Batch& rows = *problem.rows;
  VectorXd w = shape.first_weights(settings.seed);
  VectorXd errors;
  MatrixXd jacobian;
  rows.errors(shape, w, errors, &jacobian);
  MatrixXd normal = normal_matrix(jacobian);
  Evidence evidence;
  evidence.rows = settings.independent_share * static_cast<double>(errors.size());
  double damping = 1;
  BestWeights best(problem, kStepsWithoutGain);
  if (problem.held_out != nullptr) best.offer(w, errors.squaredNorm() / rows.total_weight());
  TrainerResult result;
  const int most_steps = std::min(settings.epochs, kMostSteps);
  for (; result.epochs < most_steps; ++result.epochs) {
    result.stopped_early = best.exhausted();
    result.interrupted =
        settings.go_on && !settings.go_on(static_cast<double>(result.epochs) / most_steps);
    if (result.stopped_early || result.interrupted) break;
    const double cost = evidence.cost(errors, w);
    const VectorXd gradient = jacobian.transpose() * errors + evidence.alpha * w;
    double fall = 0;
    for (; damping <= kMostDamping; damping *= 10) {
      MatrixXd system = normal;
      system.diagonal().array() += evidence.alpha + damping;
      const VectorXd tried = w - system.llt().solve(gradient);
      VectorXd tried_errors;
      rows.errors(shape, tried, tried_errors, nullptr);
      fall = cost - evidence.cost(tried_errors, tried);
      if (fall > 0) {
        w = tried;
        damping = std::max(damping / 10, kLeastDamping);
        break;
      }
    }
    if (fall <= 0) break;
    rows.errors(shape, w, errors, &jacobian);
    normal = normal_matrix(jacobian);
    evidence.update(normal, errors, w);
    if (problem.held_out != nullptr) best.offer(w, errors.squaredNorm() / rows.total_weight());
    if (fall < kConverged * cost) break;
  }
  if (problem.held_out == nullptr) best.offer(w, errors.squaredNorm() / rows.total_weight());
  best.put_into(result);
  result.effective_parameters = evidence.gamma;
  return result;
}

}  // namespace fogcomp
