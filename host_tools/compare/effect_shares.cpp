#include "compare/effect_shares.hpp"

#include <algorithm>
#include <cmath>

namespace fogcomp::compare {
namespace {

struct Spread {
  double mean = 0;
  double squares = 0;  // sum, about the mean
};

template <class Value>
Spread spread_of(std::size_t count, Value value_at) {
  Spread spread;
  for (std::size_t i = 0; i < count; ++i) spread.mean += value_at(i);
  spread.mean /= static_cast<double>(std::max<std::size_t>(1, count));
  for (std::size_t i = 0; i < count; ++i) spread.squares += std::pow(value_at(i) - spread.mean, 2);
  return spread;
}

}  // namespace

EffectShare share_of(const std::string& name, const std::vector<double>& part_dph,
                     const std::vector<double>& residual_dph,
                     const std::vector<double>& measured_dph) {
  const std::size_t count = part_dph.size();
  const Spread part = spread_of(count, [&](std::size_t i) { return part_dph[i]; });
  const Spread with = spread_of(count, [&](std::size_t i) { return residual_dph[i]; });
  const Spread without =
      spread_of(count, [&](std::size_t i) { return residual_dph[i] + part_dph[i]; });
  const Spread raw = spread_of(count, [&](std::size_t i) { return measured_dph[i]; });
  const double degrees_of_freedom = std::max(1.0, static_cast<double>(count) - 1);
  return {name, part.mean, std::sqrt(part.squares / degrees_of_freedom),
          raw.squares > 0 ? (without.squares - with.squares) / raw.squares : 0};
}

}  // namespace fogcomp::compare
