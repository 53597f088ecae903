#pragma once

#include "cli/option.hpp"
#include "denoise/denoise.hpp"
#include "denoise/filters.hpp"

namespace fogcomp::cli {

/// Hard thresholding (keeps details above the threshold) or soft (moves them towards 0 by it).
struct HardOrSoft : Choice<bool> {
  HardOrSoft(OptionGroup* group, bool is_rare)
      : Choice(group, {"mode", "NAME", "soft or hard thresholds", "soft", is_rare},
               {{"soft", false}, {"hard", true}}) {}
};

/// The options of a denoising method.
struct DenoiseOptions : OptionGroup {
  using OptionGroup::OptionGroup;
  /// Throws InputError for an option without effect on the method.
  denoise::DenoiseMethod value() const;

  Choice<denoise::DenoiseBy> method{
      this,
      {"method", "NAME",
       "wavelet; lifting: wavelet (2,2) in lifting form; kalman: smoother, ARMA noise", "wavelet"},
      {{"wavelet", denoise::DenoiseBy::wavelet},
       {"lifting", denoise::DenoiseBy::lifting},
       {"kalman", denoise::DenoiseBy::kalman}}};
  Choice<std::string> wavelet{
      this,
      {"wavelet", "NAME", "haar, db2 to db10, sym2 to sym10 or coif1 to coif5", "sym8"},
      as_named(denoise::wavelet_names())};
  Integer<int> levels{this, {"levels", "N", "of the decomposition, 1 to 20", "5"}, 1, 20};
  Choice<denoise::ThresholdRule> threshold{
      this,
      {"threshold", "RULE", "heursure, sqtwolog, rigrsure or minimaxi", "heursure"},
      in_order<denoise::ThresholdRule>(denoise::threshold_rule_names())};
  HardOrSoft mode{this, !kRare};

 private:
  void refuse(const Option& option, bool meaningless) const;
};

}  // namespace fogcomp::cli
