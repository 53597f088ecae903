#include "cli/denoise_options.hpp"

#include "support/input_error.hpp"

namespace fogcomp::cli {

// Refuses an option that would have no effect.
void DenoiseOptions::refuse(const Option& option, bool meaningless) const {
  if (!meaningless || !option.given()) return;
  throw InputError("--" + option.name,
                   "means nothing to --method " + method.text() + "; leave it out");
}

denoise::DenoiseMethod DenoiseOptions::value() const {
  denoise::DenoiseMethod chosen;
  chosen.by = method.value();
  refuse(wavelet, chosen.by != denoise::DenoiseBy::wavelet);
  for (const Option* option : std::initializer_list<const Option*>{&levels, &threshold, &mode}) {
    refuse(*option, chosen.by == denoise::DenoiseBy::kalman);
  }
  chosen.wavelet = wavelet.value();
  chosen.levels = levels.value();
  chosen.rule = threshold.value();
  chosen.hard = mode.value();
  return chosen;
}

}  // namespace fogcomp::cli
