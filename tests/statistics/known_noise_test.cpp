#include "noise/noise_coefficients.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "unit/compare/noise_generator.hpp"

namespace fogcomp {
namespace {

struct Count {
  const char* name;
  int right = 0;

  void add(const std::optional<noise::NoiseCoefficient>& estimate, double truth) {
    if (estimate && std::fabs(estimate->value - truth) <= estimate->half_width_95) ++right;
  }
};

// Three days at 1 Hz, with coefficients chosen so that each rules about a decade of averaging
// times: Q below 10 s, N to 100 s, B to 1000 s, K to 8000 s, R beyond.
TEST(KnownNoise, HasAllFiveCoefficientsWithinTheirStatedConfidence) {
  compare::NoiseTruth truth;
  truth.quantization_deg = 5e-5;
  truth.angle_random_walk_dprh = 0.0005;
  truth.bias_instability_dph = 0.006;
  truth.rate_random_walk_dphrh = 0.04;
  truth.rate_ramp_dphh = 0.1;
  constexpr std::size_t kSamples = std::size_t{1} << 18U;
  Count q{"Q"};
  Count n{"N"};
  Count b{"B"};
  Count k{"K"};
  Count r{"R"};
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto rate = compare::make_noise(truth, kSamples, 1, seed);
    const noise::NoiseCoefficients found =
        noise::fit_noise_coefficients(noise::allan_deviation(rate, {{0, rate.size()}}, 1));
    q.add(found.quantization_deg, truth.quantization_deg);
    n.add(found.angle_random_walk_dprh, truth.angle_random_walk_dprh);
    b.add(found.bias_instability_dph, truth.bias_instability_dph);
    k.add(found.rate_random_walk_dphrh, truth.rate_random_walk_dphrh);
    r.add(found.rate_ramp_dphh, truth.rate_ramp_dphh);
  }
  for (const Count& count : {q, n, b, k, r}) {
    std::printf("%s within its 95 %% interval in %d of 100 seeds\n", count.name, count.right);
    EXPECT_GE(count.right, 90) << count.name;
  }
}

}  // namespace
}  // namespace fogcomp
