#include "judge/explanations.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "judge/set_search.hpp"
#include "support/decompositions.hpp"
#include "support/units.hpp"

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

// For each effect the size from which on the rows would have shown it, deg/h rms over the rows: one
// of this size is as probable as none, so that it is found in half of all cases. Of its shapes,
// half are seen from this size on. `left`: squares that are noise, in each noise of `search`.
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

// A set's columns, and their inner products in each band.
struct Columns {
  Columns(const Rivals& rivals, const std::vector<Part>& parts)
      : numbers(rivals.columns_of(parts)), products(rivals.band_products(parts)) {}

  std::vector<Eigen::Index> numbers;
  Eigen::MatrixXd products;
};

// What sets explain in one noise, by any sizes.
class Shares {
 public:
  Shares(const Rivals& rivals, const Likelihood& likelihood, const AtNoise& noise)
      : rivals_(rivals), likelihood_(likelihood), noise_(noise) {}

  // chi^2 above what as much noise would bring.
  double explained(const Columns& set, bool with_something_else) const {
    const auto [square, columns] = square_of(set, with_something_else);
    const double white = std::max((noise_.left - square) / rivals_.freedom(), 1e-12);
    return square / white - columns;
  }

  // What a set of any sizes leaves, and its likelihood.
  double left(const Columns& set, bool with_something_else) const {
    return noise_.left - square_of(set, with_something_else).square;
  }
  double log_likelihood(const Columns& set) const {
    return likelihood_(noise_.log_density, left(set, false));
  }

 private:
  struct Explained {
    double square = 0;
    double columns = 0;
  };

  Explained square_of(const Columns& set, bool with_something_else) const {
    const double least = likelihood_.least_precision();
    Eigen::VectorXd shrink = Eigen::VectorXd::Zero(noise_.smooth.size());
    if (with_something_else) shrink = (noise_.smooth.array() + least).inverse();
    const Explained by_smooth{(shrink.array() * noise_.with_smooth.array().square()).sum(),
                              shrink.dot(noise_.smooth)};
    if (set.numbers.empty()) return by_smooth;
    const Eigen::MatrixXd in_model = noise_.model_in_effects(Eigen::all, set.numbers);
    const Eigen::MatrixXd in_smooth = noise_.smooth_in_effects(Eigen::all, set.numbers);
    Eigen::MatrixXd own = weighted(set.products, noise_.weights, in_model.cols()) -
                          in_model.transpose() * in_model -
                          in_smooth.transpose() * shrink.asDiagonal() * in_smooth;
    own.diagonal().array() += least;
    const Eigen::VectorXd with_drift =
        noise_.with_drift(set.numbers) -
        in_smooth.transpose() * shrink.cwiseProduct(noise_.with_smooth);
    return {by_smooth.square + with_drift.dot(solve_definite(own, with_drift)),
            by_smooth.columns + static_cast<double>(own.cols())};
  }

  const Rivals& rivals_;
  const Likelihood& likelihood_;
  const AtNoise& noise_;
};

// Those in the noise in which a set is most probable.
Shares shares_beside(const Rivals& rivals, const FoundSets& search, const Columns& set) {
  const AtNoise* best = &search.noises.front();
  double max = -HUGE_VAL;
  for (const AtNoise& noise : search.noises) {
    const double likely = Shares(rivals, search.likelihood, noise).log_likelihood(set);
    if (likely <= max) continue;
    max = likely;
    best = &noise;
  }
  return {rivals, search.likelihood, *best};
}

// All sets, most probable first.
void take_sets(const FoundSets& search, Explanations& found) {
  double best = -HUGE_VAL;
  for (const EffectSet& set : search.sets) best = std::max(best, set.total());
  double sum = 0;
  for (const EffectSet& set : search.sets) {
    const auto probability = [&](std::size_t with) {
      return std::exp(set.log_prior + set.log_likelihood[with] - best);
    };
    Explanation one;
    one.parts = set.parts;
    one.something_else = probability(1);
    one.without_it = probability(0);
    one.probability = one.something_else + one.without_it;
    sum += one.probability;
    found.all.push_back(std::move(one));
  }
  for (Explanation& one : found.all) {
    one.probability /= sum;
    one.something_else /= sum;
    one.without_it /= sum;
    found.something_else += one.something_else;
    if (one.parts.empty()) found.nothing = one.without_it;
  }
  std::stable_sort(
      found.all.begin(), found.all.end(),
      [](const Explanation& a, const Explanation& b) { return a.probability > b.probability; });
}

// The part without which the others explain least.
const Part& largest_part(const Rivals& rivals, const Shares& shares,
                         const std::vector<Part>& parts) {
  std::vector<double> explained;
  for (const Part& part : parts) {
    std::vector<Part> others;
    std::copy_if(parts.begin(), parts.end(), std::back_inserter(others),
                 [&](const Part& other) { return other.effect != part.effect; });
    explained.push_back(shares.explained({rivals, others}, false));
  }
  return parts[static_cast<std::size_t>(std::min_element(explained.begin(), explained.end()) -
                                        explained.begin())];
}

// What an explanation explains, and what of it is the largest: in the drift as it is, all rows
// counting alike. Whether something else is more than all of it is asked beside the noise, which it
// would fit.
void set_shares(const Rivals& rivals, const Shares& shares, const Shares& of_drift, double excess,
                Explanation& one) {
  one.mostly_something_else = one.parts.empty();
  if (one.parts.empty()) return;
  const Columns all(rivals, one.parts);
  const double explained = shares.explained(all, false);
  one.explained = std::clamp(explained / excess, 0.0, 1.0);
  one.largest = largest_part(rivals, of_drift, one.parts).effect;
  one.mostly_something_else = shares.explained(all, true) - explained > explained;
}

void add_effects(const Rivals& rivals, const FoundSets& search, const Shares& shares,
                 Explanations& found) {
  for (std::size_t e = 0; e < rivals.effects(); ++e) {
    const EffectSet& alone = search.sets[e + 1];
    Explanations::Effect effect;
    effect.shape = alone.parts.front().shape;
    effect.explained =
        std::clamp(shares.explained({rivals, alone.parts}, false) / found.excess, 0.0, 1.0);
    effect.log_odds = alone.likelihood() - search.sets.front().likelihood();
    for (std::size_t s = 0; s < rivals.shape_count(e); ++s) {
      effect.log_likelihood.push_back(search.of_shapes[rivals.number_of({e, s})]);
    }
    bool is_likeliest = true;
    for (const Explanation& one : found.all) {
      const auto part = std::find_if(one.parts.begin(), one.parts.end(),
                                     [&](const Part& own) { return own.effect == e; });
      if (part == one.parts.end()) continue;
      if (is_likeliest) effect.shape = part->shape;
      is_likeliest = false;
      effect.probability += one.probability;
      if (one.largest != e) continue;
      effect.largest += one.mostly_something_else ? one.without_it : one.probability;
    }
    found.effects.push_back(std::move(effect));
  }
}

// What each effect would have needed to be seen, in what the most probable explanation leaves.
void add_visibility(const Rivals& rivals, const FoundSets& search, const Columns& best,
                    Explanations& found) {
  const Explanation& likeliest = found.all.front();
  const bool something_else = 2 * likeliest.something_else > likeliest.probability;
  std::vector<double> left;
  for (const AtNoise& noise : search.noises) {
    left.push_back(Shares(rivals, search.likelihood, noise).left(best, something_else));
  }
  const std::vector<double> sizes = visible_from_dph(rivals, search, left);
  for (std::size_t e = 0; e < sizes.size(); ++e) found.effects[e].visible_from_dph = sizes[e];
}

NoiseLevels noise_if_nothing(const Rivals& rivals, const FoundSets& search) {
  const std::vector<double>& likely = search.of_nothing;
  const double max = *std::max_element(likely.begin(), likely.end());
  double total = 0;
  NoiseLevels square;
  for (std::size_t i = 0; i < likely.size(); ++i) {
    const AtNoise& noise = search.noises[i];
    const double probability = std::exp(likely[i] - max);
    const double white = probability * rivals.white() * noise.left / rivals.freedom();
    total += probability;
    square.white_dph += white;
    square.flicker_dph += white * noise.ratios.flicker;
    square.walk_dph_per_rth += white * noise.ratios.walk;
    square.turn_on_dph += white * noise.ratios.turn_on;
  }
  return {std::sqrt(square.white_dph / total), std::sqrt(square.flicker_dph / total),
          std::sqrt(square.walk_dph_per_rth / total / rivals.rows().row_s * kSecondsPerHour),
          std::sqrt(square.turn_on_dph / total)};
}

}  // namespace

bool Explanation::has(std::size_t effect) const {
  return std::any_of(parts.begin(), parts.end(),
                     [&](const Part& part) { return part.effect == effect; });
}

Explanations explain(const ModeSpace& space, Eigen::MatrixXd something_else,
                     std::vector<PossibleEffect> effects) {
  const Rivals rivals(space, std::move(something_else), std::move(effects));
  const FoundSets search = search_sets(rivals);
  Explanations found;
  take_sets(search, found);
  const Columns best(rivals, found.all.front().parts);
  const Shares shares = shares_beside(rivals, search, best);
  const double by_best = shares.explained(best, false);
  found.excess = std::max({shares.explained(best, true), by_best, 1e-9});
  found.left_by_best = std::clamp(1 - by_best / found.excess, 0.0, 1.0);
  const Shares of_drift(rivals, search.likelihood, search.noises.front());  // white
  for (Explanation& one : found.all) {
    set_shares(rivals, shares, of_drift, found.excess, one);
    if (one.mostly_something_else) found.mostly_something_else += one.something_else;
  }
  add_effects(rivals, search, shares, found);
  add_visibility(rivals, search, best, found);
  found.noise_if_nothing = noise_if_nothing(rivals, search);
  return found;
}

}  // namespace fogcomp::judge
