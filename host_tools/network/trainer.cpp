#include "network/trainer.hpp"

#include <algorithm>

#include "support/input_error.hpp"

namespace fogcomp::network {

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

}  // namespace fogcomp::network
