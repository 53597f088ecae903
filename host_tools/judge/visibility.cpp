#include "judge/visibility.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fogcomp::judge {
namespace {

// Logarithm of how much more probable rows are with an effect of this size than without, both alike
// beforehand, in all noises. `place`: of its one shape.
double log_odds(const FoundSets& search, const std::vector<double>& left, const Place& place,
                double size) {
  const std::size_t sizes = search.likelihood.sizes().size();
  const std::vector<Beside> priors(sizes, {1 / static_cast<double>(sizes), 0});
  const double coefficient = size / std::sqrt(static_cast<double>(place.count));
  Sum without;
  Sum with;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const AtNoise& noise = search.noises[i];
    const auto own = place.within(noise.own);
    const Eigen::VectorXd with_drift = coefficient * own.rowwise().sum();
    const double square = left[i] + coefficient * with_drift.sum();
    without.add(search.likelihood(noise.log_density, square), {1, 0});
    search.likelihood.add_average(priors, noise.log_density, square, own, with_drift, with);
  }
  return with.log_total() - without.log_total();
}

// The shape that half of the others show less of.
const Place& middle_shape(const Rivals& rivals, const AtNoise& noise, std::size_t effect) {
  std::vector<std::pair<double, std::size_t>> visible;
  for (std::size_t s = 0; s < rivals.shape_count(effect); ++s) {
    const std::size_t shape = rivals.first_shape(effect) + s;
    visible.emplace_back(rivals.shapes()[shape].within(noise.own).trace(), shape);
  }
  const auto middle = visible.begin() + static_cast<std::ptrdiff_t>(visible.size() / 2);
  std::nth_element(visible.begin(), middle, visible.end());
  return rivals.shapes()[middle->second];
}

}  // namespace

std::vector<double> visible_from_dph(const Rivals& rivals, const FoundSets& search,
                                     const std::vector<double>& left) {
  constexpr double kLeast = 1e-4;  // of a row's white noise
  constexpr double kDecades = 8;
  constexpr int kHalvings = 12;  // to less than a hundredth
  const std::vector<double>& likely = search.of_nothing;
  const AtNoise& noise = search.noises[static_cast<std::size_t>(
      std::max_element(likely.begin(), likely.end()) - likely.begin())];
  std::vector<double> sizes;
  for (std::size_t e = 0; e < rivals.effects(); ++e) {
    const Place& shape = middle_shape(rivals, noise, e);
    const double needed = search.sets.front().log_prior - search.sets[e + 1].log_prior +
                          std::log(static_cast<double>(rivals.shape_count(e)));
    double low = std::log(kLeast);
    double high = low + kDecades * std::log(10.0);
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (low + high) / 2;
      (log_odds(search, left, shape, std::exp(middle)) < needed ? low : high) = middle;
    }
    sizes.push_back(std::exp((low + high) / 2) * std::sqrt(rivals.white()));
  }
  return sizes;
}

}  // namespace fogcomp::judge
