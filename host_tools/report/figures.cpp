#include "report/figures.hpp"

#include "support/text.hpp"

namespace fogcomp::report {

std::string dph(const std::optional<double>& value) {
  return value ? rounded(*value) : "-";
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
