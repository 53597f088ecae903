#include "findings/figures.hpp"

#include <algorithm>
#include <cmath>

#include "support/text.hpp"

namespace fogcomp::findings {

namespace {

constexpr int kSignificant = 4;

int digits_before_point(double size) {
  return static_cast<int>(std::floor(std::log10(size))) + 1;
}

}  // namespace

Text significant(double value) {
  constexpr double kExact = 1e15;
  const double size = std::fabs(value);
  if (!std::isfinite(value)) return "-";
  if (size == std::floor(size) && size < kExact) return verbatim(format("%.0f", value));
  if (size < 1e-4) return verbatim(format("%.*e", kSignificant - 1, value));
  return verbatim(format("%.*f", std::max(0, kSignificant - digits_before_point(size)), value));
}

Text number(double rate_dph) {
  return verbatim(rounded(rate_dph));
}

Text dph(const std::optional<double>& value) {
  return value ? number(*value) : Text("-");
}

std::string with_sigma(double value, double sigma, bool sign) {
  if (!(sigma > 0) || !std::isfinite(sigma)) return sign ? signed_rounded(value) : rounded(value);
  const int decimals = std::max(0, 2 - digits_before_point(sigma));
  return format(sign ? "%+.*f +- %.*f" : "%.*f +- %.*f", decimals, value, decimals, sigma);
}

std::string percent(double share) {
  return format("%.0f %%", 100 * share);
}

}  // namespace fogcomp::findings
