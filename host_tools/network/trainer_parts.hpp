#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "network/trainer.hpp"

namespace fogcomp::network {

/// Random numbers of the trainers. The distributions of the standard libraries differ; this does
/// not.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : bits_(seed) {}

  /// In [0, 1).
  double unit() { return std::ldexp(static_cast<double>(bits_() >> 11U), -53); }
  /// In [-size, size).
  double within(double size) { return size * (2 * unit() - 1); }
  /// 0 to count - 1.
  std::size_t index(std::size_t count) {
    return static_cast<std::size_t>(unit() * static_cast<double>(count));
  }

 private:
  std::mt19937_64 bits_;
};

/// Stores the best weights of a training, judged by the held-out rows if there are any, else by the
/// training rows.
class BestWeights {
 public:
  /// `patience`: number of offers without improvement on the held-out rows that ends the training.
  BestWeights(const TrainingProblem& problem, int patience)
      : problem_(problem), patience_(patience) {}

  /// `mean_square`: of the training rows.
  void offer(const Eigen::VectorXd& weights, double mean_square) {
    const double judged = problem_.held_out == nullptr
                              ? mean_square
                              : problem_.held_out->mean_square(problem_.shape, weights);
    ++since_best_;
    if (!(judged < min_)) return;
    min_ = judged;
    weights_ = weights;
    mean_square_ = mean_square;
    since_best_ = 0;
  }
  bool exhausted() const { return problem_.held_out != nullptr && since_best_ > patience_; }

  const Eigen::VectorXd& weights() const { return weights_; }
  double mean_square() const { return mean_square_; }

 private:
  const TrainingProblem& problem_;
  int patience_;
  int since_best_ = 0;
  double min_ = std::numeric_limits<double>::infinity();
  double mean_square_ = 0;
  Eigen::VectorXd weights_;
};

/// Gradient descent with momentum and adaptive learning rate, starting at `first`: rules and
/// constants of MATLAB's traingdx (network/README.md).
TrainerResult descend(const TrainingProblem& problem, const TrainerSettings& settings,
                      const Eigen::VectorXd& first);

}  // namespace fogcomp::network
