#include "cli/denoise_options.hpp"

#include "wavelet/filters.hpp"

namespace fogcomp::cli {

std::vector<Option> denoise_options() {
  return {{"wavelet", "NAME", "haar, db2 to db10, sym2 to sym10 or coif1 to coif5", "sym8"},
          {"levels", "N", "of the decomposition, 1 to 20", "5"},
          {"threshold", "RULE", "heursure, sqtwolog, rigrsure or minimaxi", "heursure"},
          {"mode", "NAME", "soft or hard thresholds", "soft"}};
}

DenoiseMethod denoise_method(const Arguments& arguments) {
  DenoiseMethod method;
  method.wavelet = arguments.choice("wavelet", wavelet_names());
  method.levels = static_cast<int>(arguments.integer("levels", 1, 20));
  method.rule = threshold_rule(arguments.choice("threshold", threshold_rule_names()));
  method.hard = arguments.choice("mode", {"soft", "hard"}) == "hard";
  return method;
}

}  // namespace fogcomp::cli
