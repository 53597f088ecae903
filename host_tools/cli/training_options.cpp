#include "cli/training_options.hpp"

#include <cstdio>

#include "support/text.hpp"

namespace fogcomp::cli {

std::string TrainingOptions::trainer_summaries() {
  std::string text;
  for (const Trainer& trainer : trainers()) {
    text += (text.empty() ? "" : "; ") + std::string(trainer.name) + ": " + trainer.summary;
  }
  return text;
}

NetworkSettings TrainingOptions::value() const {
  NetworkSettings settings;
  settings.hidden = network.value();
  settings.hidden_activation = activation.value();
  settings.trainer = trainer.value();
  settings.training.seed = seed.value();
  settings.training.epochs = epochs.value();
  settings.training.goal = goal.value();
  settings.training.learning_rate = learning_rate.value();
  settings.training.particles = particles.value();
  settings.training.iterations = iterations.value();
  return settings;
}

std::string network_verdict(const FitResult& fit) {
  if (!fit.network_judged) return "";
  const OutOfSample& judged = *fit.network_judged;
  const std::string figures = out_of_sample_words(judged);
  return judged.helps() ? "network: helps out of sample: " + figures
                        : "network: nothing left that it can learn: " + figures + ": none kept";
}

TrainingWatch::TrainingWatch(TrainerSettings& settings) : progress_("training") {
  settings.go_on = [this](double done) {
    if (!guard_) guard_.emplace();
    progress_.update(done);
    return !guard_->interrupted();
  };
}

void TrainingWatch::report(const TrainerResult& result) const {
  if (!result.interrupted) return;
  std::fprintf(stderr, "interrupted: the best network of %s is kept\n",
               counted(static_cast<std::size_t>(result.epochs), "epoch").c_str());
}

}  // namespace fogcomp::cli
