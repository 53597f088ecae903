#include "diagnosis/structure.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <unsupported/Eigen/FFT>

#include "dataset/input_columns.hpp"
#include "identification/least_squares.hpp"
#include "identification/row_filters.hpp"
#include "support/chi_square.hpp"
#include "support/median.hpp"

namespace fogcomp {
namespace {

constexpr int kTemperatureKnots = 8;
constexpr int kRateKnots = 6;
constexpr int kProductKnots = 4;
constexpr int kTimeKnots = 8;  // per run
constexpr int kMostTimeKnots = 32;
constexpr std::array<double, 4> kHistoryLags_s{240, 960, 3840, 15360};
constexpr std::array<double, 4> kRadii_degc{2, 5, 10, 20};

Eigen::VectorXd column_of(const Rows& rows,
                          const std::function<double(const fog::Signals<RealNumbers>&)>& value) {
  Eigen::VectorXd column(rows.size());
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    column[i] = value(rows.signals[static_cast<std::size_t>(i)]);
  }
  return column;
}

// Cubic B-splines over the range of x, evenly spaced: smooth, local, and they sum to 1.
Eigen::MatrixXd smooths(const Eigen::VectorXd& x, int knots) {
  const double least = x.minCoeff();
  const double step = (x.maxCoeff() - least) / (knots - 1);
  Eigen::MatrixXd columns(x.size(), step > 0 ? knots : 0);
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    columns.col(k) = x.unaryExpr([&](double value) {
      const double u = std::abs((value - least) / step - static_cast<double>(k));
      if (u >= 2) return 0.0;
      return u < 1 ? 2.0 / 3 - u * u + u * u * u / 2 : std::pow(2 - u, 3) / 6;
    });
  }
  return columns;
}

Eigen::VectorXd played(const Rows& rows, const Eigen::VectorXd& x, double radius) {
  Eigen::VectorXd behind(x.size());
  double state = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    state = rows.starts_run(static_cast<std::size_t>(i))
                ? x[i]
                : std::clamp(state, x[i] - radius, x[i] + radius);
    behind[i] = x[i] - state;
  }
  return behind;
}

Eigen::MatrixXd of_time(const Rows& rows) {
  const auto runs = static_cast<int>(rows.run_starts.size());
  const int knots = std::clamp(kMostTimeKnots / runs, 3, kTimeKnots);
  std::vector<Eigen::MatrixXd> parts;
  for (const RowRange& run : rows.runs()) {
    const auto first = static_cast<Eigen::Index>(run.first);
    const auto count = static_cast<Eigen::Index>(run.size());
    const Eigen::VectorXd time = Eigen::Map<const Eigen::VectorXd>(&rows.time_s[run.first], count);
    Eigen::MatrixXd here = smooths(time, knots);
    Eigen::MatrixXd part = Eigen::MatrixXd::Zero(rows.size(), here.cols());
    part.middleRows(first, count) = here;
    parts.push_back(std::move(part));
  }
  return side_by_side(parts, rows.size());
}

}  // namespace

std::vector<StructureGroup> structure_groups(const Rows& rows) {
  const Eigen::VectorXd temperature = column_of(rows, [](const auto& s) { return s.temperature; });
  const Eigen::VectorXd rate = column_of(rows, [](const auto& s) { return s.temperature_rate; });
  std::vector<StructureGroup> groups;
  groups.push_back({"temperature_degc", smooths(temperature, kTemperatureKnots)});
  groups.push_back({"temperature_rate", smooths(rate, kRateKnots)});
  const Eigen::MatrixXd product = smooths(temperature, kProductKnots);
  groups.push_back({"temperature_degc x temperature_rate",
                    side_by_side({rate.asDiagonal() * product,
                                  rate.cwiseAbs2().asDiagonal() *
                                      product.leftCols(std::min<Eigen::Index>(2, product.cols()))},
                                 rows.size())});
  std::vector<Eigen::MatrixXd> history;
  for (const double tau_s : kHistoryLags_s) history.push_back(behind_lag(rows, temperature, tau_s));
  for (const double radius : kRadii_degc) history.push_back(played(rows, temperature, radius));
  groups.push_back({"temperature history", side_by_side(history, rows.size())});
  groups.push_back({"time_s", of_time(rows)});

  const auto add_input = [&](std::string_view name, const Eigen::VectorXd& values) {
    if (!(values.maxCoeff() > values.minCoeff())) return;
    const Eigen::VectorXd x = values.array() - values.mean();
    groups.push_back({std::string(name),
                      side_by_side({x, x.cwiseAbs2(), x.cwiseProduct(temperature)}, rows.size())});
  };
  add_input("input_rate_dph", column_of(rows, [](const auto& s) { return s.block.input_rate; }));
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
    add_input(input_column(static_cast<fog::Input>(i)).name,
              column_of(rows, [i](const auto& s) { return s.block.extension[i]; }));
  }
  return groups;
}

namespace {

constexpr std::size_t kFirstLine = 8;  // periods in a run; slower is smooth structure
constexpr std::size_t kFirstBand = 20;
constexpr std::size_t kNeighbours = 16;  // on either side, which say what is usual there
constexpr std::size_t kMostOctaves = 24;
constexpr std::size_t kLeastLines = 8;  // in an octave
constexpr double kLeastExcess = 0.2;    // of an octave: less is a noise model that is a bit off
// A level from 32 neighbours is uncertain itself: chances count for less.
constexpr double kLevelUncertainty = 0.75;

struct Octave {
  double power = 0;
  double count = 0;
  double period_s = 0;
};

std::vector<double> periodogram(const std::vector<double>& values) {
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> spectrum;
  fft.fwd(spectrum, values);
  std::vector<double> powers;
  for (std::size_t k = 0; 2 * k < values.size(); ++k) {
    powers.push_back(std::norm(spectrum[k]) / static_cast<double>(values.size()));
  }
  return powers;
}

// Mean power of noise, of which half the lines have less than ln 2 times as much.
double level_of(const std::vector<double>& powers, std::size_t first, std::size_t end) {
  return median({powers.begin() + static_cast<std::ptrdiff_t>(first),
                 powers.begin() + static_cast<std::ptrdiff_t>(end)}) /
         std::log(2.0);
}

// The strongest line against its neighbours: a noise model that is off by some colour does not
// matter, and a line that is there in the soaks too was taken for noise by it.
void find_line(const std::vector<double>& powers, double length_s, FastStructure& fast) {
  for (std::size_t k = kFirstLine; k < powers.size(); ++k) {
    const std::size_t first = std::max(kFirstLine, k < kNeighbours ? 0 : k - kNeighbours);
    const std::size_t end = std::min(powers.size(), first + 2 * kNeighbours + 1);
    if (end - first < kNeighbours) return;
    const double power = powers[k] / level_of(powers, first, end);
    if (power <= fast.line_power) continue;
    fast.line_power = power;
    fast.line_period_s = length_s / static_cast<double>(k);
  }
}

}  // namespace

FastStructure find_fast_structure(const Rows& rows, const Eigen::VectorXd& whitened_residual) {
  std::vector<Octave> octaves(kMostOctaves);
  std::vector<double> all;
  FastStructure fast;
  for (const RowRange& run : rows.runs()) {
    const std::size_t size = run.size();
    const double length_s = static_cast<double>(size) * rows.row_s;
    const auto begin = whitened_residual.begin() + static_cast<std::ptrdiff_t>(run.first);
    const std::vector<double> powers =
        periodogram({begin, begin + static_cast<std::ptrdiff_t>(size)});
    find_line(powers, length_s, fast);
    for (std::size_t k = kFirstBand; k < powers.size(); ++k) {
      const double octave = std::log2(static_cast<double>(size) / (2 * static_cast<double>(k)));
      Octave& place = octaves[std::min(kMostOctaves - 1, static_cast<std::size_t>(octave))];
      place.power += powers[k];
      place.count += 1;
      place.period_s += length_s / static_cast<double>(k);
      all.push_back(powers[k]);
    }
  }
  if (all.empty()) return fast;
  // White noise may be a little more or less than the quiet parts had.
  const double level = level_of(all, 0, all.size());
  const auto lines = static_cast<double>(all.size());
  fast.line_log_p = std::min(0.0, std::log(lines) - kLevelUncertainty * fast.line_power);
  for (const Octave& octave : octaves) {
    if (octave.count < kLeastLines) continue;
    // Twice an exponential variable of mean 1 is chi^2 with two degrees.
    const double mean = octave.power / octave.count / level;
    const double score = standard_score(2 * octave.count * mean, 2 * octave.count);
    const double log_p = score < 1 ? 0 : tail_log_p(score) + std::log(12.0);
    if (log_p >= fast.band_log_p || mean - 1 < kLeastExcess) continue;
    fast.band_log_p = log_p;
    fast.band_excess = mean - 1;
    fast.band_period_s = octave.period_s / octave.count;
    fast.share = (mean - 1) * octave.count / lines;
  }
  if (fast.line_log_p < fast.band_log_p) fast.share = fast.line_power / lines;
  return fast;
}

}  // namespace fogcomp
