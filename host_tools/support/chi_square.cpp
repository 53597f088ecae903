#include "support/chi_square.hpp"

#include <cmath>

namespace fogcomp {

double standard_score(double chi_square, double degrees_of_freedom) {
  if (degrees_of_freedom < 1) return 0;
  const double spread = 2 / (9 * degrees_of_freedom);
  return (std::cbrt(chi_square / degrees_of_freedom) - (1 - spread)) / std::sqrt(spread);
}

double tail_log_p(double score) {
  constexpr double kRootTwoPi = 2.5066;
  return score < 1 ? 0 : -score * score / 2 - std::log(score * kRootTwoPi);
}

}  // namespace fogcomp
