#include "judge/rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/units.hpp"

namespace fogcomp::judge {
namespace {

constexpr double kBandsOfAnOctave = 6;

// About its mean, unless that is all there is of it: a constant.
double size_of(const Eigen::VectorXd& column) {
  constexpr double kRoundingOnly = 1e-6;
  const double rms = column.norm() / std::sqrt(static_cast<double>(column.size()));
  const double varying = rms_about_mean(column);
  return std::max(1e-300, varying > kRoundingOnly * rms ? varying : rms);
}

}  // namespace

Eigen::MatrixXd bridged(const Rows& rows, Eigen::MatrixXd values) {
  const Eigen::VectorXd& weights = rows.weights;
  values.array().colwise() *= weights.array().sqrt();
  for (const recording::RowRange& stretch : rows.stretches) {
    const auto end = static_cast<Eigen::Index>(stretch.end);
    Eigen::Index before = -1;
    for (auto row = static_cast<Eigen::Index>(stretch.first); row < end; ++row) {
      if (weights[row] > 0) {
        before = row;
        continue;
      }
      Eigen::Index after = row + 1;
      while (after < end && !(weights[after] > 0)) ++after;
      if (after == end && before < 0) break;  // no row of the stretch counts
      const double part = before < 0 || after == end ? 0
                                                     : static_cast<double>(row - before) /
                                                           static_cast<double>(after - before);
      const Eigen::RowVectorXd left = values.row(before < 0 ? after : before);
      const Eigen::RowVectorXd right = values.row(after == end ? before : after);
      values.row(row) = left + part * (right - left);
    }
  }
  return values;
}

Eigen::MatrixXd power_on_columns(const Rows& rows) {
  const auto power_ons = static_cast<Eigen::Index>(rows.power_ons.size());
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(rows.size(), power_ons);
  for (Eigen::Index i = 0; i < power_ons; ++i) {
    const recording::RowRange& range = rows.power_ons[static_cast<std::size_t>(i)];
    all.col(i)
        .segment(static_cast<Eigen::Index>(range.first), static_cast<Eigen::Index>(range.size()))
        .setOnes();
  }
  return all;
}

Eigen::ArrayXd density_of_temperature(const Rows& rows, const ModeBands& bands) {
  const TemperatureError& error = rows.temperature;
  if (!(error.rate_walk_degc2_per_s3 > 0)) return Eigen::ArrayXd::Zero(bands.size());
  const Eigen::ArrayXd square = (bands.angle() / rows.row_s).square();  // (rad/s)^2
  const Eigen::ArrayXd of_temperature =
      1 / (1 / error.white_degc2_s + square.square() / error.rate_walk_degc2_per_s3) / rows.row_s;
  const double per_min = kSecondsPerMinute * error.slope_dph_min_per_degc;
  return of_temperature * (std::pow(error.slope_dph_per_degc, 2) + per_min * per_min * square);
}

double log_prior_of_temperature(double factor) {
  constexpr double kSigma = 0.7;  // of the logarithm
  return -std::pow(std::log(factor) / kSigma, 2) / 2;
}

ModeSpace::ModeSpace(Rows rows)
    : rows_(std::move(rows)), bands_(rows_.stretches, kBandsOfAnOctave) {}

Eigen::MatrixXd ModeSpace::of_effect(const Eigen::MatrixXd& columns) const {
  Eigen::MatrixXd scaled = bridged(rows_, columns);
  for (Eigen::Index i = 0; i < scaled.cols(); ++i) scaled.col(i) /= size_of(scaled.col(i));
  const Eigen::MatrixXd modes = bands_.modes(scaled);
  return modes.topRows(bands_.needed(modes));
}

double rms_about_mean(const Eigen::VectorXd& column) {
  return std::sqrt((column.array() - column.mean()).square().mean());
}

}  // namespace fogcomp::judge
