#include "cli/training_options.hpp"

namespace fogcomp::cli {

std::string TrainingOptions::trainer_summaries() {
  std::string text;
  for (const Trainer& trainer : trainers()) {
    text += (text.empty() ? "" : "; ") + std::string(trainer.name) + ": " + trainer.summary;
  }
  return text;
}

TrainerSettings TrainingOptions::value() const {
  TrainerSettings settings;
  settings.seed = seed.value();
  settings.epochs = epochs.value();
  settings.goal = goal.value();
  settings.learning_rate = learning_rate.value();
  settings.particles = particles.value();
  settings.iterations = iterations.value();
  return settings;
}

std::string network_verdict(const FitResult& fit) {
  if (!fit.network_judged) return "";
  const OutOfSample& judged = *fit.network_judged;
  const std::string figures = out_of_sample_words(judged);
  return judged.helps() ? "network: helps out of sample: " + figures
                        : "network: nothing left that it can learn: " + figures + ": none kept";
}

}  // namespace fogcomp::cli
