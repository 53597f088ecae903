#include "judge/mode_space.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fogcomp::judge {
namespace {

constexpr double kBandsOfAnOctave = 6;

// About its mean, unless that is all there is of it: a constant.
double size_of(const Eigen::VectorXd& column) {
  constexpr double kTiny = 1e-300;
  constexpr double kRoundingOnly = 1e-6;
  const double rms = column.norm() / std::sqrt(static_cast<double>(column.size()));
  const double varying = rms_about_mean(column);
  return std::max(kTiny, varying > kRoundingOnly * rms ? varying : rms);
}

}  // namespace

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
