#include "board/delays.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "denoise/filters.hpp"
#include "model/catalogue.hpp"
#include "support/text.hpp"

namespace fogcomp::board {
namespace {

// Lags of lags settle one after the other: the largest sum of time constants that are nested.
double slowest_chain_s(const model::Expression& expression, const std::vector<double>& constants) {
  std::vector<double> sums(expression.nodes.size());
  for (std::size_t i = 0; i < expression.nodes.size(); ++i) {
    const model::ExpressionNode& node = expression.nodes[i];  // without operands: left, right 0
    sums[i] = node.kind == model::NodeKind::lag ? sums[node.left] + constants[node.right]
                                                : std::max(sums[node.left], sums[node.right]);
  }
  return sums.empty() ? 0 : sums.back();
}

double slowest_lag_s(const model::EffectTerm& term) {
  double slowest = 0;
  if (term.expression) {
    const model::Expression& expression = term.expression->expression;
    return slowest_chain_s(expression, expression.constants(term.shape()));
  }
  const model::TermInfo info = model::info_of(term);
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    const fog::Time time = info.parameters[i].time;
    const bool settles = time == fog::Time::constant || time == fog::Time::constant_of_rate;
    if (settles) slowest = std::max(slowest, term.parameters[i].value);
  }
  return slowest;
}

using Taps = std::vector<double>;  // of a low-pass filter; their sum is 1

// Of small signals; `frequency` in cycles per sample.
double small_signal_gain(const Taps& low, std::size_t levels, double frequency) {
  double gain = 1;
  for (std::size_t level = 0; level < levels; ++level) {
    const double radians = 2 * M_PI * std::ldexp(frequency, static_cast<int>(level));
    std::complex<double> response = 0;
    double phase = 0;
    for (const double tap : low) {
      response += tap * std::polar(1.0, phase);
      phase -= radians;
    }
    gain *= std::norm(response);
  }
  return gain;
}

// 1 at a frequency of 0, and at most a half where the coarsest level is decimated.
double minus_3db_cycles(const Taps& low, std::size_t levels) {
  constexpr int kBisections = 40;
  double below = 0;
  double above = std::ldexp(0.5, -static_cast<int>(levels));
  for (int i = 0; i < kBisections; ++i) {
    const double middle = (below + above) / 2;
    (small_signal_gain(low, levels, middle) > M_SQRT1_2 ? below : above) = middle;
  }
  return below;
}

RateResponse response_of(const Taps& low, std::size_t levels, double period_s) {
  const std::size_t delay = fog::denoise_delay(low.size(), levels);
  return {delay, static_cast<double>(delay) * period_s, minus_3db_cycles(low, levels) / period_s};
}

}  // namespace

double settling_time_s(const model::Model& model) {
  double slowest = 0;
  for (const model::EffectTerm& term : model.terms)
    slowest = std::max(slowest, slowest_lag_s(term));
  for (const model::RealInput& input : model.network.inputs)
    slowest = std::max(slowest, input.tau_s);
  return 7 * model.derivative_tau_s + 5 * slowest;
}

std::string settling_words(const model::Model& model) {
  std::vector<std::string> lags;
  for (const model::EffectTerm& term : model.terms) {
    if (slowest_lag_s(term) > 0) lags.push_back(term.name);
  }
  if (lags.empty()) return "";
  return format("no rate is valid for the first %.0f s after power-on, until the lags of ",
                settling_time_s(model)) +
         join(lags, ", ") + " have settled (export --invalid chooses what makes a rate invalid)";
}

std::string delay_text(double seconds) {
  constexpr double kInMillisecondsBelowS = 10;
  return seconds < kInMillisecondsBelowS ? format("%.4g ms", 1e3 * seconds) : time_text(seconds);
}

RateResponse denoised_response(const fog::ModelParameters& parameters) {
  const fog::DenoiseParameters& denoise = parameters.denoise;
  if (denoise.levels() == 0) return {0, 0, std::numeric_limits<double>::infinity()};
  Taps low;
  for (const std::int32_t tap : denoise.low()) low.push_back(std::ldexp(tap, -fog::kTapFraction));
  return response_of(low, denoise.levels(), 1e-6 * parameters.acquisition.sample_period_us);
}

RateResponse response_told(std::uint32_t delay_and_tap, double period_s) {
  const std::size_t delay = delay_and_tap & UINT16_MAX;
  const double tap = std::ldexp(static_cast<std::int32_t>(delay_and_tap), -fog::kTapFraction);
  for (const std::string& wavelet : denoise::wavelet_names()) {
    Taps low = denoise::lowpass_filter(wavelet);
    for (double& one : low) one /= M_SQRT2;
    if (std::abs(low[low.size() / 2] - tap) > std::ldexp(1, -15)) continue;
    for (std::size_t levels = 1; levels <= fog::kMaxLevels; ++levels) {
      if (fog::denoise_delay(low.size(), levels) != delay) continue;
      return response_of(low, levels, period_s);
    }
  }
  return {delay, static_cast<double>(delay) * period_s, std::nan("")};
}

std::string late_text(const RateResponse& response) {
  const std::string bandwidth =
      std::isnan(response.minus_3db_hz)
          ? "by a filter unknown to this tool"
          : format("-3 dB at %.3g Hz for what is below its thresholds", response.minus_3db_hz);
  return format("%s late (%zu samples), ", delay_text(response.delay_s).c_str(),
                response.delay_samples) +
         bandwidth;
}

std::string rate_words(const fog::ModelParameters& parameters) {
  const std::string undelayed = "undelayed, with the gyro's own bandwidth";
  const bool sends_kvh = parameters.output != fog::OutputSelection::compact;
  const bool chosen = (parameters.output_options & fog::kRotationIsUndelayed) != 0U;
  const std::string frames = sends_kvh ? "KVH frames: " : "compact frames: ";
  const RateResponse response = denoised_response(parameters);
  if (chosen || response.delay_samples == 0) return frames + undelayed;
  return frames + (sends_kvh ? "" : undelayed + ", and ") + "denoised, " + late_text(response);
}

}  // namespace fogcomp::board
