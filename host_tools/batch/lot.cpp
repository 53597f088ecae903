#include "batch/lot.hpp"

#include <algorithm>
#include <cmath>

#include "support/statistics.hpp"
#include "support/text.hpp"

namespace fogcomp::batch {
namespace {

// The variance of ln(1.4826 MAD) of n normal values is 1.36/n, that of their standard deviation
// 1/(2n): the spread is as uncertain as a standard deviation of kEfficiency * n values. lot_test
// counts the reported gyros.
constexpr double kEfficiency = 0.37;

// Integral of sin^power from 0 to `angle`, by Simpson's rule.
double sine_integral(double power, double angle) {
  constexpr int kSteps = 1000;
  const double step = angle / kSteps;
  double sum = std::pow(std::sin(angle), power);
  for (int i = 1; i < kSteps; ++i)
    sum += (i % 2 == 1 ? 4 : 2) * std::pow(std::sin(i * step), power);
  return sum * step / 3;
}

// Value of Student's distribution that is exceeded, on either side, with this probability: with t =
// sqrt(degrees of freedom) cot(angle) the tail is an integral of sin^(degrees of freedom - 1).
double student_bound(double chance, double degrees_of_freedom) {
  constexpr int kHalvings = 50;
  const double right = std::acos(0.0);
  const double whole = sine_integral(degrees_of_freedom - 1, right);
  double inside = right;
  double beyond = 0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (inside + beyond) / 2;
    (sine_integral(degrees_of_freedom - 1, middle) < chance * whole ? beyond : inside) = middle;
  }
  return std::sqrt(degrees_of_freedom) / std::tan(beyond);
}

std::vector<double> values_of(const std::vector<GyroResult>& results, const std::string& figure) {
  std::vector<double> values;
  for (const GyroResult& result : results) {
    const auto value = result.figure(figure);
    if (value && std::isfinite(*value)) values.push_back(*value);
  }
  return values;
}

LotFigure figure_of(const std::vector<GyroResult>& results, const std::string& name) {
  std::vector<double> values = values_of(results, name);
  LotFigure figure{name, values.size(), 0, 0, false};
  if (values.size() < kMinLot) return figure;
  figure.ratios =
      name.find('.') == std::string::npos && *std::min_element(values.begin(), values.end()) > 0;
  figure.median = median(values);
  const double centre = figure.ratios ? std::log(figure.median) : figure.median;
  for (double& value : values) value = (figure.ratios ? std::log(value) : value) - centre;
  figure.spread = sigma_by_median(std::move(values));
  return figure;
}

}  // namespace

double LotFigure::score(double value) const {
  return (ratios ? std::log(value / median) : value - median) / spread;
}

double LotFigure::value_at(double score) const {
  return ratios ? median * std::exp(score * spread) : median + score * spread;
}

Lot compare_lot(const std::vector<GyroResult>& results, const std::vector<std::string>& compared) {
  Lot lot;
  std::size_t values = 0;
  std::size_t gyros = 0;
  for (const std::string& name : compared) {
    LotFigure figure = figure_of(results, name);
    if (!(figure.spread > 0)) continue;
    values += figure.gyros;
    gyros = gyros == 0 ? figure.gyros : std::min(gyros, figure.gyros);
    lot.figures.push_back(std::move(figure));
  }
  if (lot.figures.empty()) return lot;
  lot.bound = student_bound(kFalseAlarm / static_cast<double>(values),
                            kEfficiency * static_cast<double>(gyros - 1));
  for (const LotFigure& figure : lot.figures) {
    for (const GyroResult& result : results) {
      const auto value = result.figure(figure.name);
      if (!value || !(std::abs(figure.score(*value)) > lot.bound)) continue;
      lot.outliers.push_back({result.gyro, figure.name, *value, figure.score(*value)});
    }
  }
  std::stable_sort(
      lot.outliers.begin(), lot.outliers.end(),
      [](const Outlier& a, const Outlier& b) { return std::abs(a.score) > std::abs(b.score); });
  return lot;
}

std::string outlier_words(const Lot& lot, const Outlier& outlier) {
  const auto figure =
      std::find_if(lot.figures.begin(), lot.figures.end(),
                   [&](const LotFigure& one) { return one.name == outlier.figure; });
  const std::string spread = figure->ratios ? format("%.2g %%", 100 * std::expm1(figure->spread))
                                            : format("%.2g", figure->spread);
  return format("%s %.3g (lot %.3g +- %s: %.1f spreads %s)", outlier.figure.c_str(), outlier.value,
                figure->median, spread.c_str(), std::abs(outlier.score),
                outlier.score > 0 ? "above" : "below");
}

}  // namespace fogcomp::batch
