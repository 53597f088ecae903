#include "fit/derivative_choice.hpp"

#include <array>
#include <cmath>

#include "compare/decision_rules.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::fit {
namespace {

constexpr std::array<double, 6> kTimes{1.0 / 30, 0.1, 0.3, 3, 10, 30};

// Rms of the gyro's drift that the board's regressors cannot follow.
double left_by(const model::Model& model, const KnownRegressors& known) {
  const series::Rows& rows = known.series().rows();
  const Eigen::VectorXd drift = known.drift_dph(model.terms, series::Reading::of_gyro);
  std::vector<Eigen::MatrixXd> columns;
  for (const model::EffectTerm& term : model.terms) columns.push_back(*known(model::of_gyro(term)));
  const Eigen::VectorXd left = solve_linear(side_by_side(columns, rows.size()), drift).residual;
  return weighted_rms(left, rows.weights);
}

}  // namespace

double delay_error_dph(const model::Model& model, const KnownRegressors& known) {
  const Eigen::VectorXd delay = known.drift_dph(model.terms, series::Reading::of_sensor) -
                                known.drift_dph(model.terms, series::Reading::of_gyro);
  return weighted_rms(delay, known.series().rows().weights);
}

std::optional<DerivativeChoice> better_derivative(const model::Model& model,
                                                  const KnownRegressors& known,
                                                  const std::vector<runs::Run>& runs) {
  if (!model.uncertainty) return std::nullopt;
  const double now_dph = left_by(model, known);
  const double other_square = std::pow(model.residual_rms_dph, 2) - now_dph * now_dph;
  const auto tells_apart = [&](double left_dph) {
    const double after = std::sqrt(std::max(0.0, other_square + left_dph * left_dph));
    return model.residual_rms_dph - after > compare::rules::kTellsApart * model.residual_rms_dph;
  };
  if (!tells_apart(0)) return std::nullopt;  // the derivative makes too little of the error
  std::optional<DerivativeChoice> best;
  for (const double times : kTimes) {
    model::Model other = model;
    other.derivative_tau_s *= times;
    const double left_dph = left_by(other, KnownRegressors(other, runs));
    if (!tells_apart(left_dph) || (best && best->delay_rms_dph <= left_dph)) continue;
    best = DerivativeChoice{other.derivative_tau_s, left_dph};
  }
  return best;
}

}  // namespace fogcomp::fit
