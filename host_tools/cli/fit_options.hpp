#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/denoise_options.hpp"
#include "cli/recording_options.hpp"
#include "fit/fit_model.hpp"
#include "model/catalogue.hpp"
#include "network/network_inputs.hpp"
#include "support/text.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::cli {

/// --network, --trainer and their options.
struct TrainingOptions : OptionGroup {
  using OptionGroup::OptionGroup;
  network::TrainerSettings value() const;

  Integer<int> network{this,
                       {"network", "N", "hidden neurons, 0 for none, at most 32", "0"},
                       0,
                       network::kMaxTrainedHidden};
  Choice<std::string> trainer{this,
                              {"trainer", "NAME", trainer_summaries(), "lm", kRare},
                              as_named(network::trainer_names())};
  Integer<std::uint64_t> seed{
      this, {"seed", "N", "of the training's random numbers", "1", kRare}, 0, 1LL << 53};
  Choice<fog::Activation> activation{
      this,
      {"activation", "NAME", "of the hidden neurons: logsig or tansig", "logsig", kRare},
      {{"logsig", fog::Activation::logsig}, {"tansig", fog::Activation::tansig}}};
  Integer<int> epochs{
      this,
      {"epochs", "N", "of traingdx, pso-bp and ga-bp; steps of lm, at most 200", "5000", kRare},
      1,
      1'000'000};
  Number goal{this,
              {"goal", "MSE", "training ends at this mean square of the normalised target (not lm)",
               "0", kRare},
              {0, 1}};
  Number learning_rate{
      this,
      {"learning-rate", "R", "of the gradient trainers at their start", "0.05", kRare},
      {1e-6, 10}};
  Integer<int> particles{
      this, {"particles", "N", "of pso-bp; population of ga-bp", "20", kRare}, 3, 1000};
  Integer<int> iterations{
      this,
      {"iterations", "N", "of the swarm or the population, before backpropagation", "300", kRare},
      0,
      100'000};
  Flag force_network{this, "force-network",
                     "keep the network even if it does not help out of sample", kRare};

 private:
  static std::string trainer_summaries();
};

/// All options that influence the result of a fit: effects, network, rows, denoisers.
struct FitOptions : OptionGroup {
  using OptionGroup::OptionGroup;
  /// The request for these recordings. Throws InputError for values out of range and missing
  /// effects. `has_prior`: which says the effects.
  workflow::FitRequest request(const std::vector<std::string>& runs,
                               const recording::ReadOptions& reading, bool has_prior = false) const;

  Text effects{this,
               {"effects", "LIST", "NAME,NAME:p=VALUE,...; ? for a value: identified"},
               model::effect_names()};
  Texts expressions{
      this, {"effect-expr", "EXPR", "a term of your own: 'late = lag(T,?tau[60,900]) - T'"}};
  Text model{this,
             {"model", "NAME", "presets: " + join(workflow::preset_names(), ", ")},
             workflow::preset_names()};
  Number average{this, {"average", "S", "rows of the fit, seconds", "10"}, {1e-3, 1e6}};
  Flag run_offsets{this, "run-offsets",
                   "a bias for each power-on even if they do not differ; the model has the mean",
                   kRare};
  TrainingOptions training{this};
  Text inputs{
      this,
      {"inputs", "LIST", "of the network: also lagged_temperature:tau=S, elapsed, supply, ...",
       "temperature,temperature_rate", kRare},
      model::network_input_names()};
  Number derivative_tau{
      this,
      {"derivative-tau", "S", "time constant of the two lags behind dT/dt", "30", kRare},
      {1e-3, 1e5}};
  BoardDenoiserOptions denoiser{this};
  GyroLimitOptions limits{this};
  Choice<std::optional<denoise::ThresholdRule>> denoise_rows{
      this,
      {"denoise-rows", "RULE", "denoise the network's training rows, by heursure, ...", "none",
       kRare},
      row_rules()};

 private:
  static Choice<std::optional<denoise::ThresholdRule>>::Meanings row_rules();
};

}  // namespace fogcomp::cli
