#include "diagnosis/two_levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "support/parallel.hpp"

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

// Log-likelihoods up to a common constant. A row that does not count (NaN) gives no information;
// time passes.

// Forward algorithm.
double log_two_levels(const Eigen::VectorXd& values, const Shape& shape, double centre) {
  const double stay = (1 + shape.decay) / 2;
  const double low = centre - shape.height / 2;
  double log_likelihood = 0;
  double upper = 0.5;
  for (const double value : values) {
    if (!std::isnan(value)) {
      const double ratio = std::exp(shape.height * (value - centre));
      const double likelihood = (1 - upper) + upper * ratio;
      log_likelihood += std::log(likelihood) - (value - low) * (value - low) / 2;
      upper *= ratio / likelihood;
    }
    upper = upper * stay + (1 - upper) * (1 - stay);
  }
  return log_likelihood;
}

// Kalman filter of a first-order Gauss-Markov process.
double log_wander(const Eigen::VectorXd& values, const Shape& shape, double centre) {
  const double variance = shape.height * shape.height / 4;
  double log_likelihood = 0;
  double state = centre;
  double doubt = variance;
  for (const double value : values) {
    if (!std::isnan(value)) {
      const double total = doubt + 1;
      const double innovation = value - state;
      log_likelihood -= (innovation * innovation / total + std::log(total)) / 2;
      state += doubt / total * innovation;
      doubt /= total;
    }
    state = centre + shape.decay * (state - centre);
    doubt = variance + shape.decay * shape.decay * (doubt - variance);
  }
  return log_likelihood;
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
  std::pair<double, double> best{-HUGE_VAL, 0};
  for (int i = 0; i < kCentres; ++i) {
    const double centre = (static_cast<double>(i) / (kCentres - 1) - 0.5) * shape.height;
    best = std::max(best, {log(values, shape, centre), centre});
  }
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

// Logarithms of the likelihood of both processes of one shape.
struct Tried {
  Shape shape;
  double dwell_rows = 0;
  double two_levels = 0;
  double wander = 0;
};

const Tried& max_of(const std::vector<Tried>& grid, double Tried::*value) {
  return *std::max_element(grid.begin(), grid.end(),
                           [&](const Tried& a, const Tried& b) { return a.*value < b.*value; });
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
  std::vector<Tried> grid;
  const double longest_dwell = kLongestDwell * static_cast<double>(longest);
  for (double dwell = kMinDwell_rows; dwell <= longest_dwell; dwell *= kDwellStep) {
    for (double height = kMinHeight; height <= kMaxHeight; height *= kHeightStep) {
      grid.push_back({{height, std::exp(-2 / dwell)}, dwell});
    }
  }
  for_each_index(grid.size(), [&](std::size_t i) {
    grid[i].two_levels = over_all(scaled, grid[i].shape, log_two_levels);
    grid[i].wander = over_all(scaled, grid[i].shape, log_wander);
  });
  TwoLevels found;
  if (grid.empty()) return found;
  const Tried& best = max_of(grid, &Tried::two_levels);
  found.height_dph = best.shape.height * white_dph;
  found.dwell_s = best.dwell_rows * row_s;
  for (const Eigen::VectorXd& values : scaled) {
    for (const double value : values) found.chi2_drop += std::isnan(value) ? 0 : value * value;
  }
  found.chi2_drop += 2 * best.two_levels;
  if (goes_to_and_fro(scaled, best.shape)) {
    found.log_odds = best.two_levels - max_of(grid, &Tried::wander).wander;
  }
  return found;
}

}  // namespace fogcomp::diagnosis
