#include "compare/branches.hpp"

#include <algorithm>

#include "compare/decision_rules.hpp"

namespace fogcomp::compare {

// A play operator on the temperature.
std::vector<Branch> branches(const std::vector<double>& temperature_degc) {
  std::vector<Branch> branch;
  if (temperature_degc.empty()) return branch;
  const auto [min, max] = std::minmax_element(temperature_degc.begin(), temperature_degc.end());
  const double radius = std::max(rules::kMinPlayDegc, rules::kPlayShareOfRange * (*max - *min)) / 2;
  double centre = temperature_degc[0];
  Branch current = Branch::none;
  for (const double value : temperature_degc) {
    const double moved = std::clamp(centre, value - radius, value + radius);
    if (moved > centre) current = Branch::heating;
    if (moved < centre) current = Branch::cooling;
    centre = moved;
    branch.push_back(current);
  }
  return branch;
}

}  // namespace fogcomp::compare
