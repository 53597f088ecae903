#include "cli/denoise_options.hpp"

#include "denoise/filters.hpp"
#include "support/input_error.hpp"

namespace fogcomp::cli {
namespace {

// An option that would be accepted and ignored.
void refuse(const Arguments& arguments, const std::string& method, const std::string& option,
            bool meaningless) {
  if (!meaningless || !arguments.has(option)) return;
  throw InputError("--" + option, "means nothing to --method " + method + "; leave it out");
}

}  // namespace

std::vector<Option> denoise_options() {
  return {{"method",
           "NAME",
           "wavelet; lifting: wavelet (2,2) in lifting form; kalman: smoother, ARMA noise",
           "wavelet",
           false,
           {"wavelet", "lifting", "kalman"}},
          {"wavelet", "NAME", "haar, db2 to db10, sym2 to sym10 or coif1 to coif5", "sym8", false,
           wavelet_names()},
          {"levels", "N", "of the decomposition, 1 to 20", "5"},
          {"threshold", "RULE", "heursure, sqtwolog, rigrsure or minimaxi", "heursure", false,
           threshold_rule_names()},
          {"mode", "NAME", "soft or hard thresholds", "soft", false, {"soft", "hard"}}};
}

DenoiseMethod denoise_method(const Arguments& arguments) {
  DenoiseMethod method;
  const std::string name = arguments.choice("method");
  method.by = name == "wavelet"   ? DenoiseBy::wavelet
              : name == "lifting" ? DenoiseBy::lifting
                                  : DenoiseBy::kalman;
  refuse(arguments, name, "wavelet", method.by != DenoiseBy::wavelet);
  for (const char* option : {"levels", "threshold", "mode"}) {
    refuse(arguments, name, option, method.by == DenoiseBy::kalman);
  }
  method.wavelet = arguments.choice("wavelet");
  method.levels = static_cast<int>(arguments.integer("levels", 1, 20));
  method.rule = threshold_rule(arguments.choice("threshold"));
  method.hard = arguments.choice("mode") == "hard";
  return method;
}

}  // namespace fogcomp::cli
