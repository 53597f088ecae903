#include "planning/weighted_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/units.hpp"

namespace fogcomp::planning {
namespace {

constexpr double kBandsPerOctave = 6;
constexpr double kMinWhite_dph = 1e-6;  // no gyro has less noise

}  // namespace

WeightedRows::WeightedRows(const std::vector<recording::RowRange>& stretches, double row_s,
                           const judge::NoiseLevels& noise)
    : bands_(stretches, kBandsPerOctave) {
  const double white = std::pow(std::max(noise.white_dph, kMinWhite_dph), 2);
  const double flicker = std::pow(noise.flicker_dph, 2) / white;
  const double walk = std::pow(noise.walk_dph_per_rth, 2) * row_s / kSecondsPerHour / white;
  weights_ = (white * bands_.noise_density(flicker, walk)).inverse().matrix();
}

Eigen::MatrixXd WeightedRows::products(const Eigen::MatrixXd& left,
                                       const Eigen::MatrixXd& right) const {
  return judge::weighted(bands_.products(bands_.modes(left), bands_.modes(right)), weights_,
                         left.cols());
}

judge::Rows rows_with(const series::SignalSeries& series, Eigen::MatrixXd columns) {
  const series::Rows& rows = series.rows();
  judge::Rows judged;
  judged.row_s = rows.row_s;
  judged.drift_dph = rows.drift_dph;
  judged.columns = std::move(columns);
  judged.prior_sigma = Eigen::VectorXd::Zero(judged.columns.cols());
  judged.first_found = judged.columns.cols();
  judged.weights = rows.weights;
  judged.stretches = rows.stretches();
  return judged;
}

}  // namespace fogcomp::planning
