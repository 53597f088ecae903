#include <cmath>
#include <cstdint>
#include <vector>

#include "board/table_parts.hpp"
#include "core/denoise/adaptive_thresholds.hpp"
#include "denoise/filters.hpp"
#include "support/input_error.hpp"

namespace fogcomp::board {
namespace {

// Taps of the low-pass filter / sqrt 2 * 2^fraction, rounded so that even and odd taps sum to one
// half each: a constant then passes exactly.
std::vector<std::int64_t> rounded_taps(const std::vector<double>& filter, int fraction) {
  std::vector<std::int64_t> taps;
  const std::int64_t half = std::int64_t{1} << (fraction - 1);
  std::int64_t missing[2] = {half, half};
  std::size_t largest[2] = {0, 1};
  for (std::size_t i = 0; i < filter.size(); ++i) {
    taps.push_back(std::llround(std::ldexp(filter[i] / std::sqrt(2), fraction)));
    missing[i % 2] -= taps.back();
    if (std::abs(filter[i]) > std::abs(filter[largest[i % 2]])) largest[i % 2] = i;
  }
  for (const std::size_t phase : {std::size_t{0}, std::size_t{1}}) {
    taps[largest[phase]] += missing[phase];
  }
  return taps;
}

// The low-pass filter reversed, with alternating signs.
std::vector<std::int64_t> mirrored(const std::vector<std::int64_t>& low) {
  std::vector<std::int64_t> high(low.rbegin(), low.rend());
  for (std::size_t i = 1; i < high.size(); i += 2) high[i] = -high[i];
  return high;
}

void write_filters(TableWriter& out, const std::vector<double>& filter) {
  const std::vector<std::int64_t> low = rounded_taps(filter, fog::kTapFraction);
  out.note("low-pass taps / sqrt 2, times 2^31");
  for (const std::int64_t tap : low) out.integer(tap, "a tap");
  out.note("synthesis taps, times 2^15, two to a word: low-pass + 65536 * high-pass, backwards");
  const std::vector<std::int64_t> coarse = rounded_taps(filter, fog::kSynthesisTapFraction);
  const std::vector<std::int64_t> coarse_high = mirrored(coarse);
  for (std::size_t i = filter.size(); i-- > 0;) {
    out.integer(coarse_high[i] * 65536 + (coarse[i] & 0xFFFF), "a synthesis tap");
  }
}

}  // namespace

void write_denoise(TableWriter& out, const model::Model& model, double period_s) {
  const model::DenoiseSettings& denoise = model.denoise;
  const std::size_t taps = denoise.levels > 0 ? denoise::lowpass_filter(denoise.wavelet).size() : 0;
  out.note(format("denoiser (%s): levels, taps, rule (%s), mode (%s)", denoise.wavelet.c_str(),
                  model::kBoardRules[static_cast<std::size_t>(denoise.rule)].c_str(),
                  denoise.hard ? "hard" : "soft"));
  out.integer(denoise.levels, "levels");
  out.integer(static_cast<std::int64_t>(taps), "taps");
  out.integer(static_cast<std::int64_t>(denoise.rule), "threshold rule");
  out.integer(denoise.hard ? 1 : 0, "threshold mode");
  if (denoise.levels == 0) return;
  write_filters(out, denoise::lowpass_filter(denoise.wavelet));
  const double sigma = model.noise_dph_rthz / std::sqrt(period_s);
  const double universal = std::sqrt(2 * std::log(fog::kThresholdBlock));
  out.note(format("thresholds, level 1 first (white noise %.4g deg/h per sample)", sigma));
  for (int level = 1; level <= denoise.levels; ++level) {
    // Taps are divided by sqrt 2 at every level, and so is the noise in the details.
    const double threshold = universal * sigma * std::exp2(-0.5 * level);
    out.real(threshold, fog::kDetailFraction, "a threshold");
  }
}

void check_noise_fits(const BoardTable& table, std::size_t first,
                      const model::DenoiseSettings& settings) {
  if (settings.levels == 0) return;
  const std::int32_t* next = table.words.data() + first;
  const auto levels = static_cast<std::size_t>(*next++);
  const auto taps = static_cast<std::size_t>(*next++);
  fog::DenoiseParameters denoise;
  denoise.rule = static_cast<fog::ThresholdRule>(*next++);
  denoise.mode = static_cast<fog::ThresholdMode>(*next++);
  denoise.filters = {next, 2 * taps};
  denoise.thresholds = {next + 2 * taps, levels};
  if (fog::noise_shift(denoise) >= 0) return;
  const double threshold_dph = std::ldexp(denoise.thresholds[0], -fog::kDetailFraction);
  std::size_t fewer = levels - 1;
  for (; fewer > 0; --fewer) {
    denoise.thresholds = {next + 2 * taps, fewer};
    if (fog::noise_shift(denoise) >= 0) break;
  }
  throw InputError(
      "export",
      format("a threshold of %.3g deg/h is more than the board's denoiser takes with %s x %d; "
             "give the sensor's --sample-rate, or --levels %zu, or a shorter --wavelet",
             threshold_dph, settings.wavelet.c_str(), settings.levels, fewer));
}

}  // namespace fogcomp::board
