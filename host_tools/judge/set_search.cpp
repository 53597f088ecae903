#include "judge/set_search.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "judge/likelihood.hpp"
#include "judge/rivals.hpp"
#include "support/parallel.hpp"

namespace fogcomp::judge {
namespace {

class SetScan {
 public:
  SetScan(const Rivals& rivals, const Likelihood& likelihood, const Setting& setting,
          const std::vector<Part>& parts, const Eigen::MatrixXd& products)
      : rivals_(rivals), likelihood_(likelihood), setting_(setting), cross_(products) {
    for (const Part& part : parts) places_.push_back(rivals.shapes()[rivals.number_of(part)]);
    const std::vector<Eigen::Index> columns = rivals.columns_of(parts);
    if (setting.smooth_number > 0) {
      const Eigen::MatrixXd& in_effects = setting.noise->smooth_in_effects;
      const Eigen::MatrixXd shrunk = setting.shrink.asDiagonal() * in_effects(Eigen::all, columns);
      cross_ -= shrunk.transpose() * in_effects;
    }
    own_ = cross_(Eigen::all, columns);
    with_drift_ = setting.with_drift(columns);
  }

  void add(double floor, Evidence& of_shapes) const {
    const Eigen::ArrayXd least_left = left_of_any_sizes();
    if (likelihood_(setting_.log_density, least_left.minCoeff()) < floor) return;
    const std::vector<Sized> all = all_sizes();
    const auto likely = [&](const Sized& set) { return likelihood_(set.log_density, set.left); };
    double best = -HUGE_VAL;
    for (const Sized& set : all) best = std::max(best, likely(set));
    for (const Sized& set : all) {
      if (likely(set) >= best - kHopeless) add_to(set, least_left, floor, of_shapes);
    }
  }

 private:
  // The set with certain sizes.
  struct Sized {
    double largest = 0;
    Eigen::MatrixXd inverse_root;  // of its products
    Eigen::VectorXd coefficients;
    double log_density = 0;
    double left = 0;
  };
  std::vector<Sized> all_sizes() const {
    const std::vector<double>& values = likelihood_.sizes();
    std::size_t count = 1;
    for (std::size_t p = 0; p < places_.size(); ++p) count *= values.size();
    std::vector<Sized> all;
    for (std::size_t number = 0; number < count; ++number) {
      Eigen::VectorXd precision(own_.cols());
      double largest = 0;
      std::size_t sizes = number;  // of the parts, the first by its remainder
      Eigen::Index first = 0;
      for (const Place& place : places_) {
        const double size = values[sizes % values.size()];
        sizes /= values.size();
        precision.segment(first, place.count)
            .setConstant(static_cast<double>(place.count) / (size * size));
        largest = std::max(largest, size);
        first += place.count;
      }
      all.push_back(sized(precision, -precision.array().log().sum(), largest));
    }
    return all;
  }

  // `precision`: inverse of each coefficient's variance.
  Sized sized(const Eigen::VectorXd& precision, double log_determinant, double largest) const {
    Eigen::MatrixXd own = own_;
    own.diagonal() += precision;
    const Eigen::LLT<Eigen::MatrixXd> solved(own);
    const Eigen::MatrixXd root = solved.matrixL();
    const Eigen::VectorXd coefficients = solved.solve(with_drift_);
    return {largest,
            root.triangularView<Eigen::Lower>().solve(
                Eigen::MatrixXd::Identity(own.rows(), own.cols())),
            coefficients,
            setting_.log_density - log_determinant / 2 - root.diagonal().array().log().sum(),
            setting_.left - with_drift_.dot(coefficients)};
  }

  // What the set and each shape more leave at least, as with the largest sizes: columns together
  // explain at most a half more than each alone.
  Eigen::ArrayXd left_of_any_sizes() const {
    const double least = likelihood_.least_precision();
    const Sized set = sized(Eigen::VectorXd::Constant(own_.cols(), least), 0, 0);
    const Eigen::VectorXd with_drift =
        setting_.with_drift - cross_.transpose().lazyProduct(set.coefficients);
    const Eigen::MatrixXd in_effects = set.inverse_root.lazyProduct(cross_);
    const Eigen::ArrayXd square =
        setting_.square.array() - in_effects.colwise().squaredNorm().transpose().array();
    const Eigen::ArrayXd gain = with_drift.array().square() / (square.max(0) + least);
    Eigen::ArrayXd left(static_cast<Eigen::Index>(rivals_.shapes().size()));
    for (Eigen::Index i = 0; i < left.size(); ++i) {
      const auto [first, count] = rivals_.shapes()[static_cast<std::size_t>(i)];
      left[i] = set.left - (count == 1 ? 1 : 1.5) * gain.segment(first, count).sum();
    }
    return left;
  }

  void add_to(const Sized& set, const Eigen::ArrayXd& least_left, double floor,
              Evidence& of_shapes) const {
    const double log_density =
        set.log_density - static_cast<double>(places_.size()) *
                              std::log(static_cast<double>(likelihood_.sizes().size()));
    const double most_left = likelihood_.left_for(log_density, floor);
    const std::vector<Beside> priors =
        likelihood_.priors_of_sizes(setting_.smooth_number, set.largest);
    Eigen::MatrixXd in_set;
    Eigen::MatrixXd own;
    Eigen::VectorXd with_drift;
    for (std::size_t i = 0; i < of_shapes.size(); ++i) {
      if (least_left[static_cast<Eigen::Index>(i)] > most_left) continue;
      const Place& place = rivals_.shapes()[i];
      const auto cross = cross_.middleCols(place.first, place.count);
      in_set = set.inverse_root.lazyProduct(cross);
      own = place.within(setting_.own) - in_set.transpose().lazyProduct(in_set);
      with_drift = setting_.with_drift.segment(place.first, place.count) -
                   cross.transpose().lazyProduct(set.coefficients);
      likelihood_.add_average(priors, log_density, set.left, own, with_drift, of_shapes[i]);
    }
  }

  const Rivals& rivals_;
  const Likelihood& likelihood_;
  const Setting& setting_;
  std::vector<Place> places_;   // of the set's parts
  Eigen::MatrixXd cross_;       // set's columns x all
  Eigen::MatrixXd own_;         // set's columns
  Eigen::VectorXd with_drift_;  // set's columns
};

// Adds to `of_shapes` how likely a set of effects with given shapes is with each shape more, in one
// setting of the noise, all sizes averaged, where the logarithm may exceed `floor`. `products`: of
// the set's columns with all columns of effects, weighted by the noise, without the model.
void scan_set(const Rivals& rivals, const Likelihood& likelihood, const Setting& setting,
              const std::vector<Part>& parts, const Eigen::MatrixXd& products, double floor,
              Evidence& of_shapes) {
  SetScan(rivals, likelihood, setting, parts, products).add(floor, of_shapes);
}

constexpr std::size_t kExtended = 6;  // sets of two that get a third
constexpr Eigen::Index kNone = -1;

class SetSearch {
 public:
  explicit SetSearch(const Rivals& rivals)
      : rivals_(rivals),
        found_{Likelihood(rivals), {}, {}, {}, {}},
        sizes_(found_.likelihood.smooth_sizes().size()),
        alone_(rivals.shapes().size()) {}

  FoundSets operator()() {
    weigh_each_alone();
    add_single_sets();
    choose_likely_noises();
    std::vector<EffectSet> pairs = extended({found_.sets.begin() + 1, found_.sets.end()});
    std::sort(pairs.begin(), pairs.end(),
              [](const EffectSet& a, const EffectSet& b) { return a.total() > b.total(); });
    if (pairs.size() > kExtended) pairs.resize(kExtended);
    extended(pairs);
    return std::move(found_);
  }

 private:
  void weigh_each_alone() {
    const std::vector<double>& smooth = found_.likelihood.smooth_sizes();
    const std::vector<NoiseRatios> ratios = possible_noises(rivals_);
    found_.noises.resize(ratios.size());
    std::vector<std::vector<Setting>> settings(found_.noises.size());
    std::vector<Evidence> found(found_.noises.size());
    for_each_index(found_.noises.size(), [&](std::size_t i) {
      found_.noises[i] = AtNoise(rivals_, ratios[i]);
      found[i].resize(alone_.size());
      for (std::size_t beside = 0; beside < smooth.size(); ++beside) {
        settings[i].emplace_back(rivals_, found_.noises[i], beside, smooth[beside]);
        const Setting& here = settings[i].back();
        const auto priors = found_.likelihood.priors_of_sizes(beside, 0);
        for (std::size_t s = 0; s < alone_.size(); ++s) {
          const Place& place = rivals_.shapes()[s];
          found_.likelihood.add_average(priors, here.log_density, here.left, place.within(here.own),
                                        here.with_drift.segment(place.first, place.count),
                                        found[i][s]);
        }
      }
    });
    for (std::size_t i = 0; i < found_.noises.size(); ++i) {
      const Setting& alone = settings[i].front();  // without something else
      found_.of_nothing.push_back(found_.likelihood(alone.log_density, alone.left));
      for (Setting& setting : settings[i]) {
        nothing_.add(found_.likelihood(setting.log_density, setting.left),
                     found_.likelihood.prior(setting.smooth_number, 0));
        settings_.push_back(std::move(setting));
      }
      for (std::size_t s = 0; s < alone_.size(); ++s) alone_[s].add(found[i][s]);
    }
    for (const Sum& likely : alone_) found_.of_shapes.push_back(likely.log_total());
  }

  void add_single_sets() {
    const EffectSet empty{{}, log_prior({}), nothing_.log()};
    found_.sets.push_back(empty);
    for (std::size_t e = 0; e < rivals_.effects(); ++e) {
      found_.sets.push_back(joined(empty, 0, e, alone_));
    }
    for (const EffectSet& set : found_.sets) best_ = std::max(best_, set.total());
  }

  // Sets of effects are no likelier than the effects that explain most, one after another, of any
  // sizes.
  void choose_likely_noises() {
    std::vector<double> most(settings_.size());
    std::vector<Eigen::Index> needed(settings_.size(), 0);
    do {
      for_each_index(settings_.size(), [&](std::size_t i) {
        if (needed[i] != kNone) most[i] = most_likely_in(settings_[i], needed[i]);
      });
    } while (know(needed));
    std::vector<Setting> likely;
    for (std::size_t first = 0; first < settings_.size(); first += sizes_) {
      const auto here = most.begin() + static_cast<std::ptrdiff_t>(first);
      if (*std::max_element(here, here + static_cast<std::ptrdiff_t>(sizes_)) < best_ - kHopeless) {
        continue;
      }
      std::move(settings_.begin() + static_cast<std::ptrdiff_t>(first),
                settings_.begin() + static_cast<std::ptrdiff_t>(first + sizes_),
                std::back_inserter(likely));
    }
    settings_ = std::move(likely);
  }

  // `needed`: the column without whose products this ends too early, or kNone.
  double most_likely_in(const Setting& setting, Eigen::Index& needed) const {
    const double least = found_.likelihood.least_precision();
    double left = setting.left;
    Eigen::VectorXd with_drift = setting.with_drift;
    Eigen::VectorXd square = setting.square;
    Eigen::MatrixXd taken(with_drift.size(), kMissingBefore.size() - 1);
    needed = kNone;
    for (Eigen::Index part = 0; part < taken.cols() && taken.rows() > 0; ++part) {
      Eigen::Index best = 0;
      left -= (with_drift.array().square() / (square.array().max(0) + least)).maxCoeff(&best);
      if (part + 1 == taken.cols()) break;
      const auto products = products_.find(best);
      if (products == products_.end()) {
        needed = best;
        break;
      }
      Eigen::VectorXd with =
          products->second * setting.noise->weights -
          setting.noise->model_in_effects.transpose() * setting.noise->model_in_effects.col(best) -
          setting.noise->smooth_in_effects.transpose() *
              setting.shrink.cwiseProduct(setting.noise->smooth_in_effects.col(best));
      for (Eigen::Index i = 0; i < part; ++i) with -= taken.col(i) * taken(best, i);
      const double norm = std::sqrt(std::max(0.0, square[best]) + least);
      taken.col(part) = with / norm;
      with_drift -= taken.col(part) * (with_drift[best] / norm);
      square -= taken.col(part).cwiseAbs2();
    }
    return found_.likelihood(setting.log_density, left);
  }

  // Makes the products of columns known; false if they were.
  bool know(const std::vector<Eigen::Index>& columns) {
    std::vector<Eigen::Index> more;
    for (const Eigen::Index column : columns) {
      if (column != kNone && products_.try_emplace(column).second) more.push_back(column);
    }
    if (more.empty()) return false;
    std::vector<Eigen::MatrixXd> products = rivals_.products_with_all(more);
    for (std::size_t i = 0; i < more.size(); ++i) products_[more[i]] = std::move(products[i]);
    return true;
  }

  // All sets with one effect more, which are added to found_.sets.
  std::vector<EffectSet> extended(const std::vector<EffectSet>& sets) {
    std::vector<Eigen::Index> needed;
    for (const EffectSet& set : sets) {
      const std::vector<Eigen::Index> columns = rivals_.columns_of(set.parts);
      needed.insert(needed.end(), columns.begin(), columns.end());
    }
    know(needed);
    std::vector<std::vector<EffectSet>> found(sets.size());
    for_each_index(sets.size(), [&](std::size_t i) { found[i] = with_one_more(sets[i]); });
    // By effects, reached from any of them.
    std::map<std::vector<std::size_t>, EffectSet> likeliest;
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
    found_.sets.insert(found_.sets.end(), all.begin(), all.end());
    return all;
  }

  // Of the set's columns with all, without the model.
  Eigen::MatrixXd products_of(const EffectSet& set, const AtNoise& noise) const {
    const std::vector<Eigen::Index> columns = rivals_.columns_of(set.parts);
    const Eigen::MatrixXd in_model = noise.model_in_effects(Eigen::all, columns);
    Eigen::MatrixXd products = -(in_model.transpose() * noise.model_in_effects);
    for (Eigen::Index i = 0; i < products.rows(); ++i) {
      products.row(i) +=
          (products_.at(columns[static_cast<std::size_t>(i)]) * noise.weights).transpose();
    }
    return products;
  }

  std::vector<EffectSet> with_one_more(const EffectSet& set) const {
    const double floor = floor_beside(set);
    Evidence evidence(alone_.size());
    for (std::size_t first = 0; first < settings_.size(); first += sizes_) {
      const Eigen::MatrixXd products = products_of(set, *settings_[first].noise);
      for (std::size_t i = first; i < first + sizes_; ++i) {
        scan_set(rivals_, found_.likelihood, settings_[i], set.parts, products, floor, evidence);
      }
    }
    const double of_shapes = averaging(set.parts);
    std::vector<EffectSet> sets;
    for (std::size_t e = 0; e < rivals_.effects(); ++e) {
      if (!may_be_added(set, e)) continue;
      EffectSet more = joined(set, of_shapes, e, evidence);
      if (more.total() > -HUGE_VAL) sets.push_back(std::move(more));
    }
    return sets;
  }

  // A set with an effect more, averaged over the shapes of all; `of_shapes`: averaging() of the
  // set.
  EffectSet joined(const EffectSet& set, double of_shapes, std::size_t effect,
                   const Evidence& evidence) const {
    const std::size_t count = rivals_.shape_count(effect);
    const Sum* const shapes = &evidence[rivals_.first_shape(effect)];
    Sum sum;
    std::size_t best = 0;
    for (std::size_t s = 0; s < count; ++s) {
      sum.add(shapes[s]);
      if (shapes[s].log_total() > shapes[best].log_total()) best = s;
    }
    EffectSet more = set;
    more.parts.push_back({effect, best});
    more.log_prior = log_prior(more.parts);
    more.log_likelihood = sum.log();
    for (double& likely : more.log_likelihood) {
      likely += of_shapes - std::log(static_cast<double>(count));
    }
    return more;
  }

  // All sets of one size are equally probable beforehand.
  double log_prior(const std::vector<Part>& parts) const {
    double prior = std::log(kMissingBefore[parts.size()]);
    auto left = static_cast<double>(rivals_.effects());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      prior += std::log(static_cast<double>(i + 1) / std::max(1.0, left--));
    }
    return prior;
  }

  // Likelihood below which no set with one effect more counts.
  double floor_beside(const EffectSet& set) const {
    std::vector<Part> parts = set.parts;
    parts.emplace_back();
    std::size_t fewest = alone_.size();
    for (std::size_t e = 0; e < rivals_.effects(); ++e) {
      fewest = std::min(fewest, rivals_.shape_count(e));
    }
    return best_ - kHopeless - log_prior(parts) + std::log(static_cast<double>(fewest));
  }

  // Logarithm of the mean over the shapes of each part relative to the shape taken, as it is alone.
  double averaging(const std::vector<Part>& parts) const {
    double sum = 0;
    for (const Part& part : parts) {
      double all = -HUGE_VAL;
      for (std::size_t s = 0; s < rivals_.shape_count(part.effect); ++s) {
        all = log_add(all, found_.of_shapes[rivals_.number_of({part.effect, s})]);
      }
      all -= found_.of_shapes[rivals_.number_of(part)];
      sum += std::min(0.0, all - std::log(static_cast<double>(rivals_.shape_count(part.effect))));
    }
    return sum;
  }

  // An effect may stand twice in a set of two.
  bool may_be_added(const EffectSet& set, std::size_t effect) const {
    const bool has_it = std::any_of(set.parts.begin(), set.parts.end(),
                                    [&](const Part& part) { return part.effect == effect; });
    return !has_it || (rivals_.may_repeat(effect) && set.parts.size() == 1);
  }

  const Rivals& rivals_;
  FoundSets found_;
  std::size_t sizes_;              // of the smooth functions
  std::vector<Setting> settings_;  // of each noise that may be likely, in the order of the sizes
  std::map<Eigen::Index, Eigen::MatrixXd> products_;  // of a column with all, in each band
  Evidence alone_;
  Sum nothing_;
  double best_ = -HUGE_VAL;  // total of the most probable set
};

}  // namespace

FoundSets search_sets(const Rivals& rivals) {
  return SetSearch(rivals)();
}

}  // namespace fogcomp::judge
