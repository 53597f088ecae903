#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fit/batch.hpp"

namespace fogcomp::fit {

/// What a trainer works on. All rows are normalised to about +-1.
struct TrainingProblem {
  Perceptron shape;
  const Batch* rows = nullptr;
  const Batch* held_out = nullptr;  ///< of other runs: where its error is smallest, training stops
};

struct TrainerSettings {
  std::uint64_t seed = 1;
  /// Epochs of the gradient trainers (5000 in the reference paper), steps of lm at most (200).
  int epochs = 5000;
  /// Training ends at this mean square (0.0004 in the reference paper). 0: never. lm ignores it,
  /// as its regularisation decides when there is no more to learn.
  double goal = 0;
  double learning_rate = 0.05;  ///< of traingdx at the start
  int particles = 20;           ///< of pso-bp, and of ga-bp's population
  int iterations = 300;         ///< of the swarm, or generations, before backpropagation
  /// Called now and then with the fraction done; false ends training with the best so far.
  std::function<bool(double)> go_on;
};

struct TrainerResult {
  Eigen::VectorXd weights;  ///< the best: by the held-out rows where there are some
  double mean_square = 0;   ///< of these weights on the training rows
  int epochs = 0;           ///< or steps, done
  bool interrupted = false;
  bool stopped_early = false;  ///< by the held-out rows
  /// Of the weights, how many the data determine (MacKay's gamma); only lm knows.
  std::optional<double> effective_parameters;
};

/// One way to find the weights of a network. Same seed, same result, on any processor.
struct Trainer {
  const char* name;
  const char* summary;  ///< a few words for --help
  TrainerResult (*train)(const TrainingProblem&, const TrainerSettings&);
};

TrainerResult train_levenberg_marquardt(const TrainingProblem&, const TrainerSettings&);
TrainerResult train_gradient_descent(const TrainingProblem&, const TrainerSettings&);
TrainerResult train_particle_swarm(const TrainingProblem&, const TrainerSettings&);
TrainerResult train_genetic(const TrainingProblem&, const TrainerSettings&);

/// The default first.
const std::vector<Trainer>& trainers();
std::vector<std::string> trainer_names();
/// `name` is one of trainer_names().
const Trainer& find_trainer(const std::string& name);

}  // namespace fogcomp::fit
