#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/denoise_options.hpp"
#include "cli/gyro_limit_options.hpp"
#include "cli/training_options.hpp"
#include "model/catalogue.hpp"
#include "network/network_inputs.hpp"
#include "support/text.hpp"
#include "workflow/fit_presets.hpp"

namespace fogcomp::cli {

/// The board's denoiser: of a model that is fitted, or changed in one that is exported.
struct BoardDenoiserOptions : OptionGroup {
  using OptionGroup::OptionGroup;
  /// `model` with what was given.
  model::DenoiseSettings over(model::DenoiseSettings model) const {
    if (wavelet.given()) model.wavelet = wavelet.value();
    if (levels.given()) model.levels = levels.value();
    if (threshold.given()) model.rule = threshold.value();
    if (mode.given()) model.hard = mode.value();
    return model;
  }
  /// For a command that has a model: its settings are the defaults.
  void default_to_model() {
    for (Option* option : std::initializer_list<Option*>{&wavelet, &levels, &threshold, &mode}) {
      option->default_value.clear();
      option->help += " (default: the model's)";
    }
  }

  Choice<std::string> wavelet{this,
                              {"wavelet", "NAME", "of the board's denoiser", "sym8", kRare},
                              as_named(denoise::wavelet_names())};
  Integer<int> levels{
      this, {"levels", "N", "of the board's denoiser, 0 for none", "5", kRare}, 0, 10};
  Choice<fog::ThresholdRule> threshold{
      this,
      {"threshold", "RULE", "of the board: heursure and sqtwolog follow the noise; or fixed",
       "heursure", kRare},
      in_order<fog::ThresholdRule>(model::kBoardRules)};
  HardOrSoft mode{this, kRare};
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
      {"denoise-rows", "RULE", "denoise what the network is trained on, by heursure, ...", "none",
       kRare},
      row_rules()};

 private:
  static Choice<std::optional<denoise::ThresholdRule>>::Meanings row_rules();
};

}  // namespace fogcomp::cli
