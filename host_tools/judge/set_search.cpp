#include "judge/set_search.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "judge/set_scan.hpp"
#include "support/parallel.hpp"

namespace fogcomp::judge {
namespace {

constexpr std::size_t kExtended = 6;  // sets of two that get a third

}  // namespace

SetSearch::SetSearch(const Rivals& rivals)
    : rivals_(rivals), likelihood_(rivals), noises_(at_noises(rivals, possible_noises(rivals))) {
  alone_.assign(rivals.shapes().size(), kNoLikelihood);
  weigh_each_alone();
  add_single_sets();
  choose_likely_noises();
  std::vector<EffectSet> pairs = extended({sets_.begin() + 1, sets_.end()});
  std::sort(pairs.begin(), pairs.end(),
            [](const EffectSet& a, const EffectSet& b) { return a.total() > b.total(); });
  if (pairs.size() > kExtended) pairs.resize(kExtended);
  extended(pairs);
}

double SetSearch::of_shape(std::size_t effect, std::size_t shape) const {
  const Beside& likely = alone_[rivals_.first_shape(effect) + shape];
  return log_add(likely[0], likely[1]);
}

void SetSearch::weigh_each_alone() {
  const std::vector<double>& smooth = likelihood_.smooth_sizes();
  std::vector<std::vector<Setting>> settings(noises_.size());
  std::vector<Evidence> found(noises_.size());
  for_each_index(noises_.size(), [&](std::size_t i) {
    found[i].assign(alone_.size(), kNoLikelihood);
    for (std::size_t beside = 0; beside < smooth.size(); ++beside) {
      settings[i].emplace_back(rivals_, noises_[i], beside, smooth[beside]);
      weigh_each_in(settings[i].back(), found[i]);
    }
  });
  for (std::size_t i = 0; i < noises_.size(); ++i) {
    of_nothing_.push_back(-HUGE_VAL);
    for (Setting& setting : settings[i]) {
      const Beside prior = likelihood_.log_prior(setting.smooth_number, 0);
      const double likely = likelihood_(setting.log_density, setting.left);
      add({prior[0] + likely, prior[1] + likely}, nothing_);
      of_nothing_.back() = log_add(of_nothing_.back(), prior[0] + likely);
      settings_.push_back(std::move(setting));
    }
    for (std::size_t shape = 0; shape < alone_.size(); ++shape) add(found[i][shape], alone_[shape]);
  }
}

void SetSearch::weigh_each_in(const Setting& setting, Evidence& evidence) const {
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    const Place& place = rivals_.shapes()[i];
    add(likelihood_.averaged(setting, setting.log_density, setting.left, 0, setting.own(i, place),
                             setting.with_drift.segment(place.first, place.count)),
        evidence[i]);
  }
}

void SetSearch::add_single_sets() {
  const EffectSet empty{{}, log_prior({}), nothing_};
  sets_.push_back(empty);
  for (std::size_t e = 0; e < rivals_.effects().size(); ++e) {
    sets_.push_back(joined(empty, 0, e, alone_));
  }
  for (const EffectSet& set : sets_) best_ = std::max(best_, set.total());
}

// Sets of effects are no likelier than the effects that explain most, one after another, of any
// sizes.
void SetSearch::choose_likely_noises() {
  const std::size_t count = likelihood_.smooth_sizes().size();
  std::vector<double> most(settings_.size());
  for_each_index(settings_.size(), [&](std::size_t i) { most[i] = most_likely_in(settings_[i]); });
  for (std::size_t i = 0; i < noises_.size(); ++i) {
    const auto first = most.begin() + static_cast<std::ptrdiff_t>(i * count);
    if (*std::max_element(first, first + static_cast<std::ptrdiff_t>(count)) >= best_ - kHopeless) {
      likely_.push_back(i);
    }
  }
  likely_weights_.resize(rivals_.bands().size(), static_cast<Eigen::Index>(likely_.size()));
  for (std::size_t i = 0; i < likely_.size(); ++i) {
    likely_weights_.col(static_cast<Eigen::Index>(i)) = noises_[likely_[i]].weights;
  }
}

double SetSearch::most_likely_in(const Setting& setting) const {
  const double least = likelihood_.least_precision();
  double left = setting.left;
  Eigen::VectorXd with_drift = setting.with_drift;
  Eigen::VectorXd square = setting.square;
  Eigen::MatrixXd taken(with_drift.size(), kMissingBefore.size() - 1);
  for (Eigen::Index part = 0; part < taken.cols() && taken.rows() > 0; ++part) {
    Eigen::Index best = 0;
    left -= (with_drift.array().square() / (square.array().max(0) + least)).maxCoeff(&best);
    Eigen::VectorXd with =
        rivals_.products_of_column(best, setting.noise->weights) -
        setting.noise->model_in_effects.transpose() * setting.noise->model_in_effects.col(best) -
        setting.noise->smooth_in_effects.transpose() *
            setting.shrink.cwiseProduct(setting.noise->smooth_in_effects.col(best));
    for (Eigen::Index i = 0; i < part; ++i) with -= taken.col(i) * taken(best, i);
    const double norm = std::sqrt(std::max(0.0, square[best]) + least);
    taken.col(part) = with / norm;
    with_drift -= taken.col(part) * (with_drift[best] / norm);
    square -= taken.col(part).cwiseAbs2();
  }
  return likelihood_(setting.log_density, left);
}

// All sets with one effect more, which are added to sets_.
std::vector<EffectSet> SetSearch::extended(const std::vector<EffectSet>& sets) {
  std::vector<std::vector<EffectSet>> found(sets.size());
  for_each_index(sets.size(), [&](std::size_t i) { found[i] = with_one_more(sets[i]); });
  std::map<std::vector<std::size_t>, EffectSet> likeliest;  // by effects, reached from any of them
  for (std::vector<EffectSet>& some : found) {
    for (EffectSet& set : some) {
      std::vector<std::size_t> effects;
      for (const Part& part : set.parts) effects.push_back(part.effect);
      std::sort(effects.begin(), effects.end());
      const auto [place, is_new] = likeliest.try_emplace(std::move(effects), set);
      if (!is_new && set.total() > place->second.total()) place->second = std::move(set);
    }
  }
  std::vector<EffectSet> all;
  for (auto& [effects, set] : likeliest) {
    best_ = std::max(best_, set.total());
    all.push_back(std::move(set));
  }
  sets_.insert(sets_.end(), all.begin(), all.end());
  return all;
}

std::vector<EffectSet> SetSearch::with_one_more(const EffectSet& set) const {
  const std::vector<Place> places = rivals_.places_of(set.parts);
  const Eigen::MatrixXd products = rivals_.band_products_with_all(places) * likely_weights_;
  const double floor = floor_beside(set);
  const std::size_t count = likelihood_.smooth_sizes().size();
  Evidence evidence(alone_.size(), kNoLikelihood);
  for (std::size_t i = 0; i < likely_.size(); ++i) {
    const Eigen::Map<const Eigen::MatrixXd> here(products.col(static_cast<Eigen::Index>(i)).data(),
                                                 products.rows() / rivals_.columns(),
                                                 rivals_.columns());
    for (std::size_t beside = 0; beside < count; ++beside) {
      const Setting& setting = settings_[likely_[i] * count + beside];
      SetScan(rivals_, likelihood_, setting, places, here).add(floor, evidence);
    }
  }
  const double of_shapes = averaging(set.parts);
  std::vector<EffectSet> sets;
  for (std::size_t e = 0; e < rivals_.effects().size(); ++e) {
    if (!may_be_added(set, e)) continue;
    EffectSet more = joined(set, of_shapes, e, evidence);
    if (more.total() > -HUGE_VAL) sets.push_back(std::move(more));
  }
  return sets;
}

// A set with an effect more, averaged over the shapes of all; `of_shapes`: averaging() of the set.
EffectSet SetSearch::joined(const EffectSet& set, double of_shapes, std::size_t effect,
                            const Evidence& evidence) const {
  const std::size_t count = rivals_.shape_count(effect);
  const Beside* const shapes = &evidence[rivals_.first_shape(effect)];
  Beside sum = kNoLikelihood;
  std::size_t best = 0;
  for (std::size_t s = 0; s < count; ++s) {
    add(shapes[s], sum);
    const auto both = [&](std::size_t shape) {
      return log_add(shapes[shape][0], shapes[shape][1]);
    };
    if (both(s) > both(best)) best = s;
  }
  EffectSet more = set;
  more.parts.push_back({effect, best});
  more.log_prior = log_prior(more.parts);
  for (std::size_t with = 0; with < sum.size(); ++with) {
    more.log_likelihood[with] = of_shapes + sum[with] - std::log(static_cast<double>(count));
  }
  return more;
}

// All sets of one size are equally probable beforehand.
double SetSearch::log_prior(const std::vector<Part>& parts) const {
  double prior = std::log(kMissingBefore[parts.size()]);
  auto left = static_cast<double>(rivals_.effects().size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    prior += std::log(static_cast<double>(i + 1) / std::max(1.0, left--));
  }
  return prior;
}

// Likelihood below which no set with one effect more counts.
double SetSearch::floor_beside(const EffectSet& set) const {
  std::vector<Part> parts = set.parts;
  parts.emplace_back();
  std::size_t fewest = alone_.size();
  for (std::size_t e = 0; e < rivals_.effects().size(); ++e) {
    fewest = std::min(fewest, rivals_.shape_count(e));
  }
  return best_ - kHopeless - log_prior(parts) + std::log(static_cast<double>(fewest));
}

// Logarithm of the mean over the shapes of each part relative to the shape taken, as it is alone.
double SetSearch::averaging(const std::vector<Part>& parts) const {
  double sum = 0;
  for (const Part& part : parts) {
    double all = -HUGE_VAL;
    for (std::size_t s = 0; s < rivals_.shape_count(part.effect); ++s) {
      all = log_add(all, of_shape(part.effect, s) - of_shape(part.effect, part.shape));
    }
    sum += std::min(0.0, all - std::log(static_cast<double>(rivals_.shape_count(part.effect))));
  }
  return sum;
}

// An effect may stand twice in a set of two.
bool SetSearch::may_be_added(const EffectSet& set, std::size_t effect) const {
  const bool has_it = std::any_of(set.parts.begin(), set.parts.end(),
                                  [&](const Part& part) { return part.effect == effect; });
  return !has_it || (rivals_.effects()[effect].may_repeat && set.parts.size() == 1);
}

}  // namespace fogcomp::judge
