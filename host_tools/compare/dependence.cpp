#include "compare/dependence.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "compare/decision_rules.hpp"
#include "noise/autocorrelation.hpp"
#include "support/decompositions.hpp"
#include "support/evidence.hpp"
#include "support/statistics.hpp"

namespace fogcomp::compare {
namespace {

constexpr std::size_t kNoClass = static_cast<std::size_t>(-1);

// Equal division of a variable's range.
class Grid {
 public:
  Grid(const std::vector<double>& values, std::size_t bins) : bins_(bins) {
    const auto [min, max] = std::minmax_element(values.begin(), values.end());
    if (values.empty()) return;
    min_ = *min;
    width_ = (*max - *min) / static_cast<double>(bins);
  }
  std::size_t bin(double value) const {
    if (width_ <= 0) return 0;
    return std::min(static_cast<std::size_t>((value - min_) / width_), bins_ - 1);
  }

 private:
  std::size_t bins_;
  double min_ = 0;
  double width_ = 0;
};

// Means of the residual over classes with enough rows, and their covariance.
struct ClassMeans {
  std::vector<std::size_t>
      place;  // index of each class among those with enough rows, else kNoClass
  Eigen::VectorXd rows;
  Eigen::VectorXd mean_dph;
  Eigen::MatrixXd covariance;  // (deg/h)^2
};

// Correlation of rows with all earlier rows of each class, through one component of the noise.
// Successive rows of one class are added together, because beside that class's own sum all earlier
// ones only decay.
class CorrelationBefore {
 public:
  explicit CorrelationBefore(Eigen::Index classes)
      : sums_(Eigen::MatrixXd::Zero(classes, classes)), earlier_(Eigen::VectorXd::Zero(classes)) {}

  void decay(double factor) {
    decayed_ *= factor;
    own_ *= factor;
  }
  void add_row(Eigen::Index place) {
    if (place != place_) begin(place);
    decayed_sum_ += decayed_;
    own_sum_ += own_;
    ++own_;
  }
  /// classes x classes: a row's own class by column.
  const Eigen::MatrixXd& finish() {
    begin(-1);
    return sums_;
  }

 private:
  void begin(Eigen::Index place) {
    if (place_ >= 0) {
      earlier_[place_] = 0;
      sums_.col(place_) += decayed_sum_ * earlier_;
      sums_(place_, place_) += own_sum_;
    }
    earlier_ *= decayed_;
    if (place_ >= 0) earlier_[place_] = own_;
    place_ = place;
    own_ = place >= 0 ? earlier_[place] : 0;
    decayed_ = 1;
    decayed_sum_ = 0;
    own_sum_ = 0;
  }

  Eigen::MatrixXd sums_;
  Eigen::VectorXd earlier_;  // sum of the decays of each class's rows, at the first of these rows
  Eigen::Index place_ = -1;  // class of these rows
  double own_ = 0;           // sum of the decays of its own rows, now
  double decayed_ = 1;       // of the earlier ones since
  double decayed_sum_ = 0;   // over these rows
  double own_sum_ = 0;
};

// Covariance of the sums over classes, from the noise model: each component correlates a row with
// earlier rows by its decay. Rows without a class contribute nothing.
Eigen::MatrixXd covariance_of_sums(const ResidualRows& rows,
                                   const std::vector<std::size_t>& place_of_row,
                                   Eigen::Index size) {
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(size, size);
  for (const std::size_t place : place_of_row) {
    if (place == kNoClass) continue;
    covariance(static_cast<Eigen::Index>(place), static_cast<Eigen::Index>(place)) +=
        std::pow(rows.noise.white_dph(), 2) + std::pow(rows.noise.wander_dph(), 2);
  }
  for (const noise::NoiseModel::Component& component : rows.noise.components) {
    CorrelationBefore before(size);
    double factor = 1;
    double factor_s = 0;  // the time for which it was computed
    for (std::size_t i = 0; i < place_of_row.size(); ++i) {
      const double passed_s = i > 0 ? rows.time_s[i] - rows.time_s[i - 1] : 0;
      if (passed_s != factor_s) factor = std::exp(-passed_s / component.tau_s);
      factor_s = passed_s;
      before.decay(factor);
      if (place_of_row[i] != kNoClass) before.add_row(static_cast<Eigen::Index>(place_of_row[i]));
    }
    const Eigen::MatrixXd& sums = before.finish();
    covariance += component.variance * (sums + sums.transpose());
  }
  return covariance;
}

// Long-run variance of a row: variance of a sum of many rows, per row.
double long_run_variance(const noise::NoiseModel& noise) {
  double variance = noise.white_variance;
  for (const noise::NoiseModel::Component& component : noise.components) {
    const double phi = std::exp(-noise.row_s / component.tau_s);
    variance += component.variance * (1 + phi) / (1 - phi);
  }
  return variance;
}

// Ratio, at least 1, of the rows' variance within their classes to that of the noise model.
double excess_scatter(const ResidualRows& rows, const std::vector<std::size_t>& place_of_row,
                      const ClassMeans& means) {
  std::vector<double> within(place_of_row.size(), 0);
  double square = 0;
  double degrees_of_freedom = -static_cast<double>(means.mean_dph.size());
  for (std::size_t i = 0; i < place_of_row.size(); ++i) {
    if (place_of_row[i] == kNoClass) continue;
    within[i] = rows.residual_dph[i] - means.mean_dph[static_cast<Eigen::Index>(place_of_row[i])];
    square += within[i] * within[i];
    ++degrees_of_freedom;
  }
  const double expected = long_run_variance(rows.noise);
  if (expected <= 0) return 1;
  const double seen =
      square / std::max(1.0, degrees_of_freedom) * noise::correlated_values(within, rows.stretches);
  return std::max(1.0, seen / expected);
}

// `class_of`: class of each row, or kNoClass.
ClassMeans means_of(const std::vector<std::size_t>& class_of, std::size_t classes,
                    const ResidualRows& rows) {
  std::vector<std::size_t> count(classes);
  for (const std::size_t one : class_of) {
    if (one != kNoClass) ++count[one];
  }
  ClassMeans means;
  Eigen::Index size = 0;
  for (std::size_t i = 0; i < classes; ++i) {
    means.place.push_back(count[i] >= rules::kMinInClass ? static_cast<std::size_t>(size++)
                                                         : kNoClass);
  }
  means.rows.setZero(size);
  means.mean_dph.setZero(size);
  std::vector<std::size_t> place_of_row;
  for (std::size_t i = 0; i < class_of.size(); ++i) {
    place_of_row.push_back(class_of[i] == kNoClass ? kNoClass : means.place[class_of[i]]);
    if (place_of_row.back() == kNoClass) continue;
    const auto place = static_cast<Eigen::Index>(place_of_row.back());
    ++means.rows[place];
    means.mean_dph[place] += rows.residual_dph[i];
  }
  const Eigen::VectorXd per_row = means.rows.cwiseInverse();
  means.mean_dph = means.mean_dph.cwiseProduct(per_row);
  means.covariance = excess_scatter(rows, place_of_row, means) * per_row.asDiagonal() *
                     covariance_of_sums(rows, place_of_row, size) * per_row.asDiagonal();
  return means;
}

bool has_noise(const ResidualRows& rows) {
  return rows.noise.white_variance > 0;
}

ClassTest test_means(const ClassMeans& means, const ResidualRows& rows) {
  ClassTest test;
  const Eigen::Index size = means.mean_dph.size();
  if (size < 2 || !has_noise(rows)) return test;
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(size);
  const Eigen::VectorXd weights = solve_semidefinite(means.covariance, ones);
  const Eigen::VectorXd apart =
      means.mean_dph.array() - weights.dot(means.mean_dph) / weights.sum();
  test.score = standard_score(apart.dot(solve_semidefinite(means.covariance, apart)),
                              static_cast<double>(size - 1));

  const Eigen::VectorXd share = means.rows / means.rows.sum();
  const double common = share.dot(means.mean_dph);
  const Eigen::VectorXd with_common = means.covariance * share;
  for (Eigen::Index i = 0; i < size; ++i) {
    const double of_noise = means.covariance(i, i) - 2 * with_common[i] + share.dot(with_common);
    test.variance_dph2 += share[i] * (std::pow(means.mean_dph[i] - common, 2) - of_noise);
  }
  test.variance_dph2 = std::max(0.0, test.variance_dph2);
  return test;
}

// Indices of the heating classes whose cooling class, the next one, has enough rows too.
using Pairs = std::vector<Eigen::Index>;

// Score of a difference between heating and cooling in any class.
double score_of(const Pairs& pairs, const ClassMeans& means) {
  const auto size = static_cast<Eigen::Index>(pairs.size());
  Eigen::MatrixXd differ = Eigen::MatrixXd::Zero(size, means.mean_dph.size());
  for (Eigen::Index i = 0; i < size; ++i) {
    differ(i, pairs[static_cast<std::size_t>(i)]) = 1;
    differ(i, pairs[static_cast<std::size_t>(i)] + 1) = -1;
  }
  const Eigen::VectorXd width = differ * means.mean_dph;
  const Eigen::MatrixXd noise = differ * means.covariance * differ.transpose();
  return standard_score(width.dot(solve_semidefinite(noise, width)), static_cast<double>(size));
}

}  // namespace

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

bool ClassTest::structured() const {
  return score > kCertainSigmas;
}

Dependence dependence_on(const std::vector<double>& variable, const ResidualRows& rows,
                         std::size_t bins) {
  const Grid grid(variable, bins);
  std::vector<std::size_t> class_of;
  std::vector<double> at(bins);
  for (const double value : variable) {
    class_of.push_back(grid.bin(value));
    at[class_of.back()] += value;
  }
  const ClassMeans means = means_of(class_of, bins, rows);
  Dependence dependence;
  dependence.test = test_means(means, rows);
  for (std::size_t i = 0; i < bins; ++i) {
    if (means.place[i] == kNoClass) continue;
    const auto place = static_cast<Eigen::Index>(means.place[i]);
    dependence.bins.push_back({at[i] / means.rows[place], means.mean_dph[place],
                               std::sqrt(means.covariance(place, place)),
                               static_cast<std::size_t>(means.rows[place])});
  }
  return dependence;
}

double sigma_of_mean(const ResidualRows& rows) {
  const std::vector<std::size_t> one_class(rows.residual_dph.size(), 0);
  const ClassMeans means = means_of(one_class, 1, rows);
  return means.mean_dph.size() == 0 ? 0 : std::sqrt(means.covariance(0, 0));
}

ClassTest test_of_mean(const ResidualRows& rows) {
  const double sigma = sigma_of_mean(rows);
  ClassTest test;
  if (sigma == 0) return test;
  double sum = 0;
  for (const double value : rows.residual_dph) sum += value;
  const double mean = sum / static_cast<double>(rows.residual_dph.size());
  test.score = std::abs(mean) / sigma;
  test.variance_dph2 = std::max(0.0, mean * mean - sigma * sigma);
  return test;
}

const LoopBin* Loop::widest() const {
  const auto widest =
      std::max_element(bins.begin(), bins.end(), [](const LoopBin& a, const LoopBin& b) {
        return std::abs(a.width_dph()) < std::abs(b.width_dph());
      });
  return widest == bins.end() ? nullptr : &*widest;
}

Loop loop_over(const std::vector<double>& temperature_degc, const ResidualRows& rows,
               std::size_t bins) {
  const Grid grid(temperature_degc, bins);
  const std::vector<Branch> branch = branches(temperature_degc);
  std::vector<std::size_t> class_of;
  std::vector<double> at(bins);
  std::vector<double> count(bins);
  for (std::size_t i = 0; i < branch.size(); ++i) {
    const std::size_t bin = grid.bin(temperature_degc[i]);
    class_of.push_back(branch[i] == Branch::none ? kNoClass
                                                 : 2 * bin + static_cast<std::size_t>(branch[i]));
    at[bin] += temperature_degc[i];
    ++count[bin];
  }
  const ClassMeans means = means_of(class_of, 2 * bins, rows);
  Loop loop;
  Pairs pairs;
  for (std::size_t i = 0; i < bins; ++i) {
    const std::size_t heating = means.place[2 * i];
    if (heating == kNoClass || means.place[2 * i + 1] == kNoClass) continue;
    const auto h = static_cast<Eigen::Index>(heating);
    pairs.push_back(h);
    const double variance =
        means.covariance(h, h) + means.covariance(h + 1, h + 1) - 2 * means.covariance(h, h + 1);
    loop.bins.push_back(
        {at[i] / count[i], means.mean_dph[h], means.mean_dph[h + 1], std::sqrt(variance)});
    const double rows_of_both = means.rows[h] + means.rows[h + 1];
    loop.test.variance_dph2 += means.rows[h] * means.rows[h + 1] / rows_of_both *
                               (std::pow(loop.bins.back().width_dph(), 2) - variance);
  }
  if (pairs.empty() || !has_noise(rows)) return loop;
  loop.test.variance_dph2 =
      std::max(0.0, loop.test.variance_dph2 / static_cast<double>(branch.size()));
  loop.test.score = score_of(pairs, means);
  return loop;
}

}  // namespace fogcomp::compare
