#include "findings/network_words.hpp"

#include "support/text.hpp"

namespace fogcomp::findings {

std::string network_verdict(const fit::FitResult& fit) {
  if (!fit.network_judged) return "";
  const fit::OutOfSample& judged = *fit.network_judged;
  const std::string figures = fit::out_of_sample_words(judged);
  return fit::helps(judged) ? "network: helps out of sample: " + figures
                            : "network: nothing left that it can learn: " + figures + ": none kept";
}

}  // namespace fogcomp::findings
