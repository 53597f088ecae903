#include "denoise/lifting.hpp"

#include <algorithm>

namespace fogcomp::denoise {
namespace {

// Right neighbour of an odd position or, at the end, the left one.
double right_of(const std::vector<double>& even, std::size_t odd) {
  return even[std::min(odd + 1, even.size() - 1)];
}

double predicted(const std::vector<double>& even, std::size_t odd) {
  return (even[odd] + right_of(even, odd)) / 2;
}

double update(const std::vector<double>& details, std::size_t even) {
  if (details.empty()) return 0;
  const std::size_t last = details.size() - 1;
  const double left = details[even == 0 ? 0 : even - 1];
  return (left + details[std::min(even, last)]) / 4;
}

}  // namespace

LiftingParts lift(fog::Span<const double> values, int levels) {
  LiftingParts parts;
  parts.approximation.assign(values.data, values.data + values.size);
  for (int level = 0; level < levels && parts.approximation.size() > 1; ++level) {
    const std::vector<double> whole = std::move(parts.approximation);
    std::vector<double> even((whole.size() + 1) / 2);
    std::vector<double> details(whole.size() / 2);
    for (std::size_t i = 0; i < even.size(); ++i) even[i] = whole[2 * i];
    for (std::size_t i = 0; i < details.size(); ++i) {
      details[i] = whole[2 * i + 1] - predicted(even, i);
    }
    for (std::size_t i = 0; i < even.size(); ++i) even[i] += update(details, i);
    parts.details.push_back(std::move(details));
    parts.approximation = std::move(even);
  }
  return parts;
}

void unlift(const LiftingParts& parts, fog::Span<double> values) {
  std::vector<double> current = parts.approximation;
  for (std::size_t level = parts.details.size(); level-- > 0;) {
    const std::vector<double>& details = parts.details[level];
    std::vector<double> even = std::move(current);
    for (std::size_t i = 0; i < even.size(); ++i) even[i] -= update(details, i);
    current.resize(even.size() + details.size());
    for (std::size_t i = 0; i < even.size(); ++i) current[2 * i] = even[i];
    for (std::size_t i = 0; i < details.size(); ++i) {
      current[2 * i + 1] = details[i] + predicted(even, i);
    }
  }
  std::copy(current.begin(), current.end(), values.data);
}

}  // namespace fogcomp::denoise
