#include "core/denoise/adaptive_thresholds.hpp"

namespace fog {
namespace {

// Noise variance in units of (universal threshold / 64)^2: 64^2 / (2 ln 128).
constexpr std::uint32_t kNoiseVariance = 422;
// A signal is weak if its mean square is below 1 + log2(n)^1.5 / sqrt(n) = 2.637 noise variances
// (Donoho & Johnstone 1995); here times n = 128 details, / kEnergyUnit.
constexpr std::uint32_t kWeakEnergy = 557;

}  // namespace

bool RiskHistogram::choose() {
  if (!full()) return false;
  const std::uint32_t left_off = energy_ < kWeakEnergy ? 0 : kWhole - min_risk();
  *this = RiskHistogram();
  reduction_ = static_cast<std::uint8_t>(left_off);
  return true;
}

// Estimated risk of threshold t, in noise variances: n - 2 #(|d| <= t) + sum min(d^2, t^2). The
// constant n is left out. Each detail counts with the mean square of its bin.
[[gnu::always_inline]] inline std::uint32_t RiskHistogram::min_risk() const {
  static_assert(UINT8_MAX * kUnits * kUnits <= INT32_MAX);
  static_assert(UINT8_MAX * 2 * kNoiseVariance <= INT32_MAX);
  std::uint32_t below = 0;
  std::uint32_t squares = 0;
  std::int32_t min = INT32_MAX;
  std::uint32_t best = kWhole;
  for (std::uint32_t sixteenths = 1; sixteenths <= kWhole; ++sixteenths) {
    const std::uint32_t count = counts_[sixteenths - 1];
    const std::uint32_t edge = sixteenths * kUnitsPerBin;
    const std::uint32_t middle = edge - kUnitsPerBin / 2;
    below += count;
    squares += count * (middle * middle + 1);  // + width^2 / 12
    const auto risk = static_cast<std::int32_t>(squares + (kThresholdBlock - below) * edge * edge) -
                      static_cast<std::int32_t>(2 * kNoiseVariance * below);
    if (risk < min) {
      min = risk;
      best = sixteenths;
    }
  }
  return best;
}

}  // namespace fog
