#include "report/figures.hpp"

#include <cmath>

#include "support/text.hpp"

namespace fogcomp::report {

std::string dph(const std::optional<double>& value) {
  constexpr double kLeast = 0.00005;
  if (!value) return "-";
  return format("%.4f", std::fabs(*value) < kLeast ? 0.0 : *value);  // no "-0.0000"
}

std::string percent(double share) {
  return format("%.0f %%", 100 * share);
}

std::string as_sentence(std::string words) {
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') {
    words[0] = static_cast<char>(words[0] - 'a' + 'A');
  }
  if (!words.empty() && words.back() != '.') words += '.';
  return words;
}

}  // namespace fogcomp::report
