#include "cli/training_options.hpp"

namespace fogcomp::cli {

std::string TrainingOptions::trainer_summaries() {
  std::string text;
  for (const network::Trainer& trainer : network::trainers()) {
    text += (text.empty() ? "" : "; ") + std::string(trainer.name) + ": " + trainer.summary;
  }
  return text;
}

network::TrainerSettings TrainingOptions::value() const {
  network::TrainerSettings settings;
  settings.seed = seed.value();
  settings.epochs = epochs.value();
  settings.goal = goal.value();
  settings.learning_rate = learning_rate.value();
  settings.particles = particles.value();
  settings.iterations = iterations.value();
  return settings;
}

}  // namespace fogcomp::cli
