#pragma once

#include <limits>

#include "network/trainer.hpp"

namespace fogcomp::network {

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

  void put_into(TrainerResult& result) const {
    result.weights = weights_;
    result.mean_square = mean_square_;
  }

 private:
  const TrainingProblem& problem_;
  int patience_;
  int since_best_ = 0;
  double min_ = std::numeric_limits<double>::infinity();
  double mean_square_ = 0;
  Eigen::VectorXd weights_;
};

}  // namespace fogcomp::network
