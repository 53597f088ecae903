#include "diagnosis/line_in_time.hpp"

#include <cmath>

#include "diagnosis/decision_rules.hpp"
#include "fit/predict.hpp"
#include "fit/undetermined.hpp"
#include "support/least_squares.hpp"
#include "support/units.hpp"

namespace fogcomp::diagnosis {

bool LineInTime::is_significant() const {
  return std::erfc(std::abs(slope_dphh) / sigma_dphh / std::sqrt(2.0)) < rules::kFaintChance;
}

std::optional<LineInTime> find_line_in_time(const DiagnosisData& data,
                                            const fit::NoiseWeightedFit& fit) {
  const series::Rows& rows = data.series().rows();
  const Eigen::VectorXd hours =
      Eigen::Map<const Eigen::VectorXd>(rows.time_s.data(), rows.size()) / kSecondsPerHour;
  const Eigen::MatrixXd beside = side_by_side({fit::run_offset_columns(rows), hours}, rows.size());
  const fit::NoiseWeightedFit with =
      fit::fit_rows(data.series(), fit.terms, beside, {{}, fit.noise, true});
  if (!fit::is_determined(with)) return std::nullopt;
  const Eigen::MatrixXd covariance = fit::predict(rows, with).covariance();
  const Eigen::Index line = with.linear() - 1;
  return LineInTime{with.coefficients[line], std::sqrt(covariance(line, line))};
}

}  // namespace fogcomp::diagnosis
