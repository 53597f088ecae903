#include "training/levenberg_marquardt.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <random>

namespace fogcomp {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kHeadRoom = 1.25;  // the largest target lies at 1/1.25 of tansig's reach
constexpr double kLeastDamping = 1e-12;
constexpr double kMostDamping = 1e12;
constexpr double kConverged = 1e-7;  // relative fall of the cost in a step

// All weights in one vector: hidden weights row by row, hidden biases, output weights, output bias.
struct Shape {
  Index inputs;
  Index hidden;
  Index size() const { return hidden * (inputs + 2) + 1; }
  Index hidden_bias() const { return hidden * inputs; }
  Index output_weight() const { return hidden * (inputs + 1); }
  Index output_bias() const { return hidden * (inputs + 2); }
};

struct Problem {
  Shape shape;
  MatrixXd inputs;  // rows x inputs, normalised
  VectorXd target;  // normalised
  VectorXd root_weights;
};

// Errors e = sqrt(w) (target - y) and their Jacobian de/dw.
void evaluate(const Problem& problem, const VectorXd& w, VectorXd& errors, MatrixXd* jacobian) {
  const Shape& shape = problem.shape;
  const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>
      hidden_weights(w.data(), shape.hidden, shape.inputs);
  MatrixXd hidden = problem.inputs * hidden_weights.transpose();
  hidden.rowwise() += w.segment(shape.hidden_bias(), shape.hidden).transpose();
  hidden = hidden.unaryExpr([](double x) { return activate(fog::Activation::logsig, x); });
  const VectorXd output_weights = w.segment(shape.output_weight(), shape.hidden);
  const VectorXd y = (hidden * output_weights).array().unaryExpr([&](double x) {
    return activate(fog::Activation::tansig, x + w[shape.output_bias()]);
  });
  errors = problem.root_weights.cwiseProduct(problem.target - y);
  if (jacobian == nullptr) return;

  jacobian->resize(errors.size(), shape.size());
  const VectorXd slope = -problem.root_weights.cwiseProduct(
      y.unaryExpr([](double v) { return activation_slope(fog::Activation::tansig, v); }));
  for (Index j = 0; j < shape.hidden; ++j) {
    const VectorXd neuron = hidden.col(j);
    const VectorXd through = slope.cwiseProduct(neuron.unaryExpr([](double v) {
      return activation_slope(fog::Activation::logsig, v);
    })) * output_weights[j];
    for (Index i = 0; i < shape.inputs; ++i) {
      jacobian->col(j * shape.inputs + i) = through.cwiseProduct(problem.inputs.col(i));
    }
    jacobian->col(shape.hidden_bias() + j) = through;
    jacobian->col(shape.output_weight() + j) = slope.cwiseProduct(neuron);
  }
  jacobian->col(shape.output_bias()) = slope;
}

RealInput min_max_input(fog::NetworkInput signal, const VectorXd& values) {
  const double least = values.minCoeff();
  const double most = values.maxCoeff();
  return {signal, (least + most) / 2, std::max((most - least) / 2, 1e-3), 0};
}

// Weights of the size at which neurons work in their curved part without saturating.
VectorXd initial_weights(const Shape& shape, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&random](double size) {
    return size * (std::ldexp(static_cast<double>(random() >> 11U), -52) - 1);
  };
  VectorXd w(shape.size());
  for (Index i = 0; i < shape.hidden_bias(); ++i) w[i] = uniform(4);
  for (Index i = 0; i < shape.hidden; ++i) {
    w[shape.hidden_bias() + i] = uniform(4);
    w[shape.output_weight() + i] = uniform(0.3);
  }
  w[shape.output_bias()] = 0;
  return w;
}

RealNetwork unpack(const Shape& shape, const VectorXd& w) {
  RealNetwork network;
  network.hidden.activation = fog::Activation::logsig;
  network.hidden.weights.resize(shape.hidden, shape.inputs);
  for (Index j = 0; j < shape.hidden; ++j) {
    for (Index i = 0; i < shape.inputs; ++i) {
      network.hidden.weights(j, i) = w[j * shape.inputs + i];
    }
  }
  network.hidden.biases = w.segment(shape.hidden_bias(), shape.hidden);
  network.output.activation = fog::Activation::tansig;
  network.output.weights = w.segment(shape.output_weight(), shape.hidden).transpose();
  network.output.biases = w.segment(shape.output_bias(), 1);
  return network;
}

// beta * sum e^2 + alpha * sum w^2, and the rules that set alpha and beta from the data.
struct Evidence {
  double alpha = 0.01;
  double beta = 1;
  double gamma = 0;

  double cost(const VectorXd& errors, const VectorXd& w) const {
    return beta * errors.squaredNorm() + alpha * w.squaredNorm();
  }
  void update(const MatrixXd& normal, const VectorXd& errors, const VectorXd& w) {
    const auto size = static_cast<double>(w.size());
    MatrixXd hessian = beta * normal;
    hessian.diagonal().array() += alpha;
    const MatrixXd inverse =
        hessian.llt().solve(MatrixXd::Identity(hessian.rows(), hessian.cols()));
    gamma = std::clamp(size - alpha * inverse.trace(), 0.0, size);
    alpha = gamma / (2 * std::max(w.squaredNorm(), 1e-12));
    beta =
        (static_cast<double>(errors.size()) - gamma) / (2 * std::max(errors.squaredNorm(), 1e-12));
    // One common factor is free; this keeps the numbers near 1.
    alpha /= beta;
    beta = 1;
  }
};

}  // namespace

TrainingResult train_levenberg_marquardt(const std::vector<fog::Signals<RealNumbers>>& signals,
                                         const VectorXd& target_dph, const VectorXd& weights,
                                         const TrainingSettings& settings) {
  const auto rows = static_cast<Index>(signals.size());
  MatrixXd values(rows, 2);
  for (Index i = 0; i < rows; ++i) {
    const auto& seen = signals[static_cast<std::size_t>(i)];
    values.row(i) << seen.temperature, seen.temperature_rate;
  }
  RealNetwork scaling;
  scaling.inputs = {min_max_input(fog::NetworkInput::temperature, values.col(0)),
                    min_max_input(fog::NetworkInput::temperature_rate, values.col(1))};
  scaling.amplitude_dph = kHeadRoom * std::max(target_dph.cwiseAbs().maxCoeff(), 1e-9);

  Problem problem;
  problem.shape = {values.cols(), settings.hidden};
  problem.inputs.resize(rows, values.cols());
  for (Index i = 0; i < rows; ++i) {
    problem.inputs.row(i) = scaling.normalised(values.row(i).transpose()).transpose();
  }
  problem.target = target_dph / scaling.amplitude_dph;
  problem.root_weights = weights.cwiseSqrt();

  VectorXd w = initial_weights(problem.shape, settings.seed);
  VectorXd errors;
  MatrixXd jacobian;
  evaluate(problem, w, errors, &jacobian);
  MatrixXd normal = jacobian.transpose() * jacobian;
  Evidence evidence;
  double damping = 1;
  TrainingResult result;
  for (result.steps = 0; result.steps < settings.most_steps; ++result.steps) {
    const double cost = evidence.cost(errors, w);
    const VectorXd gradient = evidence.beta * jacobian.transpose() * errors + evidence.alpha * w;
    double fall = 0;
    for (; damping <= kMostDamping; damping *= 10) {
      MatrixXd system = evidence.beta * normal;
      system.diagonal().array() += evidence.alpha + damping;
      const VectorXd tried = w - system.llt().solve(gradient);
      VectorXd tried_errors;
      evaluate(problem, tried, tried_errors, nullptr);
      fall = cost - evidence.cost(tried_errors, tried);
      if (fall > 0) {
        w = tried;
        damping = std::max(damping / 10, kLeastDamping);
        break;
      }
    }
    if (fall <= 0) break;
    evaluate(problem, w, errors, &jacobian);
    normal.noalias() = jacobian.transpose() * jacobian;
    evidence.update(normal, errors, w);
    if (fall < kConverged * cost) break;
  }

  result.network = unpack(problem.shape, w);
  result.network.inputs = scaling.inputs;
  result.network.amplitude_dph = scaling.amplitude_dph;
  result.effective_parameters = evidence.gamma;
  const double total = weights.sum();
  result.rms_before_dph = std::sqrt(target_dph.cwiseAbs2().dot(weights) / total);
  result.rms_after_dph = scaling.amplitude_dph * errors.norm() / std::sqrt(total);
  return result;
}

}  // namespace fogcomp
