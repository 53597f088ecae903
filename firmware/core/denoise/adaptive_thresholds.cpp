#include "core/denoise/adaptive_thresholds.hpp"

namespace fog {
namespace {

// Variance of the noise in units of (universal threshold / 64)^2: 64^2 / (2 ln 128).
constexpr std::uint32_t kNoiseVariance = 422;
// Weak below a mean square of 1 + log2(n)^1.5 / sqrt(n) = 2.637 noise variances (Donoho & Johnstone
// 1995), times n = 128 details, / kEnergyUnit.
constexpr std::uint32_t kWeakEnergy = 557;

}  // namespace

void RiskHistogram::choose() {
  const std::uint32_t sixteenths = energy_ < kWeakEnergy ? kWhole : least_risk();
  left_off_ = static_cast<std::uint8_t>(kWhole - sixteenths);
  energy_ = 0;
  details_ = 0;
  counts_.fill(0);
}

// Risk of threshold t, in noise variances: n - 2 #(|d| <= t) + sum min(d^2, t^2). The n is common
// to all; a bin's details count with the bin's mean square.
std::uint32_t RiskHistogram::least_risk() const {
  std::uint32_t below = 0;
  std::uint32_t squares = 0;
  std::int32_t least = 0;
  std::uint32_t best = kWhole;
  std::uint32_t edge = 0;
  for (std::uint32_t bin = 0; bin < kWhole; ++bin) {
    const std::uint32_t count = counts_[bin];
    const std::uint32_t middle = edge + kUnitsPerBin / 2;
    edge += kUnitsPerBin;
    below += count;
    squares += count * (middle * middle + 1);  // + width^2 / 12
    const auto risk = static_cast<std::int32_t>(squares + (kThresholdBlock - below) * edge * edge) -
                      static_cast<std::int32_t>(2 * kNoiseVariance * below);
    if (bin == 0 || risk < least) {
      least = risk;
      best = bin + 1;
    }
  }
  return best;
}

}  // namespace fog
