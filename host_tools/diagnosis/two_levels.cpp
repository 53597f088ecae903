#include "diagnosis/two_levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace fogcomp::diagnosis {
namespace {

// In units of the white noise of a row.
constexpr double kMinHeight = 0.5;
constexpr double kMaxHeight = 8;
constexpr double kHeightStep = 1.3;
constexpr double kMinDwell_rows = 8;
constexpr double kDwellStep = 1.8;
constexpr double kLongestDwell = 0.5;  // of the longest stretch
// Minimum number of complete visits: a bias that steps once, or whose record ends at another level,
// has none.
constexpr std::size_t kMinVisits = 2;
constexpr std::size_t kMinVisit_rows = 4;
constexpr int kCentres = 11;  // from half a height below the mean to half a height above

// Both processes have mean `centre` and autocovariance (height / 2)^2 decay^rows.
struct Shape {
  double height = 0;
  double decay = 0;
};

// Of the possible means of a stretch.
using Centres = Eigen::Array<double, kCentres, 1>;

Centres centres_of(const Shape& shape) {
  return shape.height * (Centres::LinSpaced(0, kCentres - 1) / (kCentres - 1) - 0.5);
}

// Sum of logarithms, as the logarithm of a product: few logarithms instead of one for each factor.
template <int kSize>
class LogProduct {
 public:
  using Factors = Eigen::Array<double, kSize, 1>;

  void multiply(const Factors& factors) {
    if (!is_moderate(factors)) {
      log_ += factors.log();
      return;
    }
    product_ *= factors;
    if (is_moderate(product_)) return;
    log_ += product_.log();
    product_.setOnes();
  }
  Factors log() const { return log_ + product_.log(); }

 private:
  static bool is_moderate(const Factors& factors) {
    return factors.minCoeff() > 1e-100 && factors.maxCoeff() < 1e100;
  }

  Factors product_ = Factors::Ones();
  Factors log_ = Factors::Zero();
};

// Log-likelihoods for every centre, up to a common constant. A row that does not count (NaN) gives
// no information; time passes.

// Forward algorithm.
Centres log_two_levels(const Eigen::VectorXd& values, const Shape& shape) {
  const double stay = (1 + shape.decay) / 2;
  const Centres centres = centres_of(shape);
  const Centres low = centres - shape.height / 2;
  const Centres ratio_at_zero = (-shape.height * centres).exp();
  LogProduct<kCentres> likelihoods;
  Centres squares = Centres::Zero();
  Centres upper = Centres::Constant(0.5);
  for (const double value : values) {
    if (!std::isnan(value)) {
      const Centres ratio = std::exp(shape.height * value) * ratio_at_zero;
      const Centres likelihood = (1 - upper) + upper * ratio;
      likelihoods.multiply(likelihood);
      squares += (value - low).square();
      upper *= ratio / likelihood;
    }
    upper = upper * stay + (1 - upper) * (1 - stay);
  }
  return likelihoods.log() - squares / 2;
}

// Kalman filter of a first-order Gauss-Markov process: its innovations are linear in the centre.
Centres log_wander(const Eigen::VectorXd& values, const Shape& shape) {
  const double variance = shape.height * shape.height / 4;
  LogProduct<1> totals;
  // Over the rows, each over its variance: of the innovation with centre 0 and of its derivative.
  double square = 0;
  double product = 0;
  double slope_square = 0;
  double state = 0;  // with centre 0
  double by_centre = 1;
  double doubt = variance;
  for (const double value : values) {
    if (!std::isnan(value)) {
      const double total = doubt + 1;
      const double innovation = value - state;
      square += innovation * innovation / total;
      product += innovation * by_centre / total;
      slope_square += by_centre * by_centre / total;
      totals.multiply(LogProduct<1>::Factors(total));
      state += doubt / total * innovation;
      by_centre /= total;
      doubt /= total;
    }
    state *= shape.decay;
    by_centre = 1 + shape.decay * (by_centre - 1);
    doubt = variance + shape.decay * shape.decay * (doubt - variance);
  }
  const Centres centres = centres_of(shape);
  const Centres squares = square - 2 * product * centres + slope_square * centres.square();
  return -(squares + totals.log()[0]) / 2;
}

double mean_of(const Eigen::VectorXd& values) {
  double sum = 0;
  double count = 0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    sum += value;
    count += 1;
  }
  return count > 0 ? sum / count : 0;
}

// The best centre of a stretch of mean 0.
template <class Log>
std::pair<double, double> best_centre(const Eigen::VectorXd& values, const Shape& shape, Log log) {
  const Centres centres = centres_of(shape);
  const Centres likelihoods = log(values, shape);
  std::pair<double, double> best{-HUGE_VAL, 0};
  for (int i = 0; i < kCentres; ++i) best = std::max(best, {likelihoods[i], centres[i]});
  return best;
}

// With the best centre for every stretch.
template <class Log>
double over_all(const std::vector<Eigen::VectorXd>& stretches, const Shape& shape, Log log) {
  double sum = 0;
  for (const Eigen::VectorXd& values : stretches) sum += best_centre(values, shape, log).first;
  return sum;
}

// Most probable sequence of levels (Viterbi): true at the upper level.
std::vector<bool> likeliest_levels(const Eigen::VectorXd& values, const Shape& shape,
                                   double centre) {
  const double change = std::log((1 - shape.decay) / (1 + shape.decay));  // relative to staying
  const auto size = static_cast<std::size_t>(values.size());
  std::vector<std::array<bool, 2>> came_from_upper(size);
  double upper_over_lower = 0;
  for (std::size_t i = 0; i < size; ++i) {
    // Better path to the lower and to the upper level, relative to having been at the lower.
    const double to_lower = std::max(0.0, upper_over_lower + change);
    const double to_upper = std::max(change, upper_over_lower);
    came_from_upper[i] = {to_lower > 0, upper_over_lower > change};
    const double value = values[static_cast<Eigen::Index>(i)];
    upper_over_lower = to_upper - to_lower;
    if (!std::isnan(value)) upper_over_lower += shape.height * (value - centre);
  }
  std::vector<bool> upper(size);
  bool now = upper_over_lower > 0;
  for (std::size_t i = size; i-- > 0;) {
    upper[i] = now;
    now = came_from_upper[i][now ? 1 : 0];
  }
  return upper;
}

// Changes of the most probable level within a stretch.
struct Changes {
  std::size_t whole_visits = 0;  // that begin and end within the stretch and last several rows
  std::size_t up = 0;            // changes with an eighth of the stretch on either side
  std::size_t down = 0;
};

Changes changes_of(const Eigen::VectorXd& values, const std::vector<bool>& upper) {
  Changes changes;
  std::vector<std::size_t> begins{0};
  std::vector<std::size_t> rows{0};  // rows of each visit that count
  for (std::size_t i = 0; i < upper.size(); ++i) {
    if (i > 0 && upper[i] != upper[i - 1]) {
      begins.push_back(i);
      rows.push_back(0);
    }
    if (!std::isnan(values[static_cast<Eigen::Index>(i)])) ++rows.back();
  }
  for (std::size_t visit = 1; visit + 1 < begins.size(); ++visit) {
    if (rows[visit] >= kMinVisit_rows) ++changes.whole_visits;
  }
  for (std::size_t visit = 1; visit < begins.size(); ++visit) {
    if (8 * std::min(rows[visit - 1], rows[visit]) < upper.size()) continue;
    ++(upper[begins[visit]] ? changes.up : changes.down);
  }
  return changes;
}

// Over all stretches.
bool goes_to_and_fro(const std::vector<Eigen::VectorXd>& stretches, const Shape& shape) {
  Changes changes;
  for (const Eigen::VectorXd& values : stretches) {
    const double centre = best_centre(values, shape, log_two_levels).second;
    const Changes here = changes_of(values, likeliest_levels(values, shape, centre));
    changes.whole_visits += here.whole_visits;
    changes.up += here.up;
    changes.down += here.down;
  }
  return changes.whole_visits >= kMinVisits || (changes.up > 0 && changes.down > 0);
}

}  // namespace

TwoLevels find_two_levels(const std::vector<Eigen::VectorXd>& stretches, double white_dph,
                          double row_s) {
  std::vector<Eigen::VectorXd> scaled;
  Eigen::Index longest = 0;
  for (const Eigen::VectorXd& stretch : stretches) {
    const Eigen::VectorXd values = stretch / white_dph;
    scaled.push_back(values.array() - mean_of(values));
    longest = std::max(longest, stretch.size());
  }
  TwoLevels found;
  Shape best;
  double two_levels = -HUGE_VAL;
  double wander = -HUGE_VAL;
  const double longest_dwell = kLongestDwell * static_cast<double>(longest);
  for (double dwell = kMinDwell_rows; dwell <= longest_dwell; dwell *= kDwellStep) {
    for (double height = kMinHeight; height <= kMaxHeight; height *= kHeightStep) {
      const Shape shape{height, std::exp(-2 / dwell)};
      wander = std::max(wander, over_all(scaled, shape, log_wander));
      const double here = over_all(scaled, shape, log_two_levels);
      if (here <= two_levels) continue;
      two_levels = here;
      best = shape;
      found.height_dph = height * white_dph;
      found.dwell_s = dwell * row_s;
    }
  }
  if (two_levels == -HUGE_VAL) return found;
  for (const Eigen::VectorXd& values : scaled) {
    for (const double value : values) found.chi2_drop += std::isnan(value) ? 0 : value * value;
  }
  found.chi2_drop += 2 * two_levels;
  if (goes_to_and_fro(scaled, best)) found.log_odds = two_levels - wander;
  return found;
}

}  // namespace fogcomp::diagnosis
