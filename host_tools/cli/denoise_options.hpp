#pragma once

#include "cli/option.hpp"
#include "denoise/filters.hpp"
#include "model/model.hpp"

namespace fogcomp::cli {

/// Hard thresholding (keeps details above the threshold) or soft (moves them towards 0 by it).
struct HardOrSoft : Choice<bool> {
  HardOrSoft(OptionGroup* group, bool is_rare)
      : Choice(group, {"mode", "NAME", "soft or hard thresholds", "soft", is_rare},
               {{"soft", false}, {"hard", true}}) {}
};

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

}  // namespace fogcomp::cli
