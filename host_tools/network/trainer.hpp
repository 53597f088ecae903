#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "network/training_rows.hpp"

namespace fogcomp::network {

/// Data of a training. All rows are normalised to about +-1.
struct TrainingProblem {
  Perceptron shape;
  const TrainingRows* rows = nullptr;
  const TrainingRows* held_out = nullptr;  ///< other runs: training stops at its smallest error
};

struct TrainerSettings {
  std::uint64_t seed = 1;
  /// Epochs of the gradient trainers (5000 in the reference paper), or largest number of steps of
  /// lm (200).
  int epochs = 5000;
  /// Training ends at this mean square (0.0004 in the reference paper); 0: never. lm ignores it,
  /// because its regularisation decides.
  double goal = 0;
  double learning_rate = 0.05;  ///< initial one of traingdx
  int particles = 20;           ///< pso-bp; population of ga-bp
  int iterations = 300;         ///< of the swarm, or generations, before backpropagation
  /// Called repeatedly with the fraction done; false ends training with the best weights so far.
  std::function<bool(double)> go_on;
};

struct TrainerResult {
  Eigen::VectorXd weights;  ///< the best ones, by the held-out rows if there are any
  double mean_square = 0;   ///< of these weights on the training rows
  int epochs = 0;           ///< or steps
  bool interrupted = false;
  bool stopped_early = false;  ///< because of the held-out rows
  /// Number of weights that the data determine (MacKay's gamma); only from lm.
  std::optional<double> effective_parameters;
};

/// A training method. Same seed, same result, on any processor.
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

}  // namespace fogcomp::network
