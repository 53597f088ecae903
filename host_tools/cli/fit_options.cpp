#include "cli/fit_options.hpp"

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

Choice<std::optional<denoise::ThresholdRule>>::Meanings FitOptions::row_rules() {
  Choice<std::optional<denoise::ThresholdRule>>::Meanings rules;
  for (const std::string& name : denoise::threshold_rule_names()) {
    rules.emplace_back(name, denoise::threshold_rule(name));
  }
  rules.emplace_back("none", std::nullopt);
  return rules;
}

workflow::FitRequest FitOptions::request(const std::vector<std::string>& runs,
                                         const recording::ReadOptions& reading,
                                         bool has_prior) const {
  workflow::FitRequest request;
  request.runs = runs;
  request.reading = reading;
  request.reading.limits = limits.value();
  request.hidden = training.network.find();
  request.activation = training.activation.value();
  request.trainer = training.trainer.find();
  request.training = training.value();
  request.force_network = training.force_network.given();
  request.preset = model.find();
  const bool needs_effects = workflow::takes_effects(request.preset) && !has_prior;
  request.effects = needs_effects ? effects.required() : effects.find();
  request.expressions = expressions.value();
  request.run_offsets = run_offsets.given();
  request.row_denoising = denoise_rows.value();
  request.network_inputs = inputs.value();
  request.average_s = average.value();
  request.derivative_tau_s = derivative_tau.find();
  request.board_denoiser = denoiser.over({});
  if (request.row_denoising && request.board_denoiser.levels == 0) {
    fail("--levels '0' is not a number from 1 to 10");
  }
  return request;
}

}  // namespace fogcomp::cli
