#include "cli/training_options.hpp"

#include <cstdio>

#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

std::string trainer_help() {
  std::string text;
  for (const Trainer& trainer : trainers()) {
    text += (text.empty() ? "" : "; ") + std::string(trainer.name) + ": " + trainer.summary;
  }
  return text;
}

fog::Activation activation(const Arguments& arguments) {
  return arguments.choice("activation") == "logsig" ? fog::Activation::logsig
                                                    : fog::Activation::tansig;
}

}  // namespace

std::vector<Option> training_options() {
  std::vector<Option> options{
      {"network", "N", "hidden neurons, 0 for none, at most 32", "0"},
      {"trainer", "NAME", trainer_help(), "lm", false, trainer_names()},
  };
  for (Option& option : rarely({
           {"seed", "N", "of all that training draws", "1"},
           {"activation",
            "NAME",
            "of the hidden neurons: logsig or tansig",
            "logsig",
            false,
            {"logsig", "tansig"}},
           {"epochs", "N", "of traingdx, pso-bp and ga-bp; steps of lm, at most 200", "5000"},
           {"goal", "MSE", "training ends at this mean square of the normalised target (not lm)",
            "0"},
           {"learning-rate", "R", "of the gradient trainers at their start", "0.05"},
           {"particles", "N", "of pso-bp; population of ga-bp", "20"},
           {"iterations", "N", "of the swarm or the population, before backpropagation", "300"},
           {"force-network", "", "keep the network even if it does not help out of sample", ""},
       })) {
    options.push_back(std::move(option));
  }
  return options;
}

NetworkSettings network_settings(const Arguments& arguments) {
  NetworkSettings settings;
  settings.hidden = static_cast<int>(arguments.integer("network", 0, kMostTrainedHidden));
  settings.hidden_activation = activation(arguments);
  settings.trainer = arguments.choice("trainer");
  TrainerSettings& training = settings.training;
  training.seed = static_cast<std::uint64_t>(arguments.integer("seed", 0, 1LL << 53));
  training.epochs = static_cast<int>(arguments.integer("epochs", 1, 1'000'000));
  training.goal = arguments.number("goal", 0, 1);
  training.learning_rate = arguments.number("learning-rate", 1e-6, 10);
  training.particles = static_cast<int>(arguments.integer("particles", 3, 1000));
  training.iterations = static_cast<int>(arguments.integer("iterations", 0, 100'000));
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
