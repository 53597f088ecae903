#pragma once

#include <optional>
#include <vector>

#include "fit/known_regressors.hpp"
#include "model/model.hpp"
#include "runs/run.hpp"

namespace fogcomp::fit {

/// Another time constant of the board's derivative, with which it would follow the gyro better.
struct DerivativeChoice {
  double tau_s = 0;
  double delay_rms_dph = 0;  ///< what delay, noise and steps of the derivative would leave
};

/// Error due to the board's delay: rms over all rows, deg/h, of the effects' drift for the board's
/// signals (means of the preceding block, causal derivative) less the gyro's own
/// (series/measured_temperature.hpp).
double delay_error_dph(const model::Model& model, const KnownRegressors& known);

/// A shorter derivative has less delay, a longer one less of the thermometer's noise. Tried are
/// a thirtieth to thirty times its length, and the present one, each with the coefficients that
/// follow the gyro's drift best. Nothing if none lowers the model's error by more than a comparison
/// tells apart (compare::rules::kTellsApart). `known`: of the model's rows of these runs.
std::optional<DerivativeChoice> better_derivative(const model::Model& model,
                                                  const KnownRegressors& known,
                                                  const std::vector<runs::Run>& runs);

}  // namespace fogcomp::fit
