#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/pipeline/model_parameters.hpp"
#include "model/model.hpp"

namespace fogcomp::board {

/// Seconds after a start until the initial states of the model's lags are negligible (1 %): seven
/// time constants of the derivative, which has two lags, plus five of the slowest lag after it, of
/// an effect, an expression or a network input. A play operator depends on the temperature, not on
/// time: the board reports it by history_unknown.
double settling_time_s(const model::Model& model);

/// "no rate is valid for the first 3228 s after power-on, until the lags of thermal_lag have
/// settled"; "" if no lag but the derivative's takes its time.
std::string settling_words(const model::Model& model);

/// Delay and bandwidth of the denoised rate, beside those of the gyro itself.
struct RateResponse {
  std::size_t delay_samples = 0;  ///< the same for every frequency
  double delay_s = 0;
  /// Frequency from which on an amplitude is less than 1 / sqrt 2 of what it was. It is that of
  /// small signals, whose details are below the thresholds on every level and are removed: the
  /// least there is. Whatever exceeds the thresholds passes. Infinite without a denoiser.
  double minus_3db_hz = 0;
};

/// From a board's parameters. Of small signals the bank leaves the approximation of its coarsest
/// level. Averaged over the phases of the decimation its gain is the product of |H(2^k f)|^2 over
/// the levels k, where H is the low-pass filter (Vaidyanathan, Multirate Systems and Filter Banks,
/// 1993, section 4.2).
RateResponse denoised_response(const fog::ModelParameters& parameters);

/// From fog::HealthWord::rate_delay. The bandwidth of no filter, or of an unknown one, is NaN.
RateResponse response_told(std::uint32_t delay_and_tap, double period_s);

/// "2325 ms late (465 samples), -3 dB at 2.85 Hz ...".
std::string late_text(const RateResponse& response);

/// A delay as users of a board read it: "2325 ms"; from 10 s on "15.5 s", "77.5 min", "2.6 h".
std::string delay_text(double seconds);

/// Which rate the frames have, one line: "KVH frames: denoised, 2325 ms late (465 samples), ...".
std::string rate_words(const fog::ModelParameters& parameters);

}  // namespace fogcomp::board
