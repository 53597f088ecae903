// How often an addition is judged rightly.
#include "refinement/add_effect.hpp"

#include <gtest/gtest.h>

#include "support/typical_effects.hpp"
#include "unit/refinement/simulated_addition.hpp"

namespace {

using namespace fog::test;
using fogcomp::Addition;
using fogcomp::Model;

// An effect that stands out by about five standard deviations is accepted in most of 20 recordings,
// one ten times as large in all.
TEST(Additions, OfATrueEffectAreAccepted) {
  for (const double size : {1.0, 10.0}) {
    Model real = truth();
    real.terms[2].coefficients_dph = {size * 0.06};
    int accepted = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Addition result =
          add("bias,bias_temperature:order=3", "temperature_rate", real, {seed});
      if (result.accepted) ++accepted;
      if (seed == 1) {
        std::printf("%g times: %.1f sigma, %s\n", size,
                    result.model.terms[2].coefficients_dph[0] / result.model.terms[2].sigma_dph[0],
                    result.reason.c_str());
      }
    }
    std::printf("%d of 20 accepted\n", accepted);
    EXPECT_GE(accepted, size > 1 ? 20 : 15);
  }
}

TEST(Additions, OfAUselessEffectAreRefused) {
  int accepted = 0;
  int tried = 0;
  for (const char* const effect :
       {"thermal_hysteresis:radius=5", "thermal_lag", "warm_up", "polarization_ripple",
        "temperature_rate_product", "bias_temperature:order=4"}) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const Addition result = add(kComplete, effect, truth(), {seed});
      ++tried;
      if (result.accepted) ++accepted;
      if (result.accepted) std::printf("%s: %s\n", effect, result.reason.c_str());
      EXPECT_EQ(result.model.history.back().forced, !result.accepted);
    }
  }
  std::printf("%d of %d useless effects accepted\n", accepted, tried);
  EXPECT_LE(accepted, 2);  // kLeastGain lets about one in 100 pass
}

TEST(Additions, AreJudgedRightlyOnHoldouts) {
  int useful = 0;
  int useless = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const std::vector<fogcomp::RunInBlocks> holdouts{run_of(truth(), 100 + seed)};
    const Addition good =
        add("bias,bias_temperature:order=3", "temperature_rate", truth(), {seed}, holdouts);
    if (good.accepted) ++useful;
    if (add(kComplete, "thermal_hysteresis", truth(), {seed}, holdouts).accepted) ++useless;
    EXPECT_LT(good.runs.at(1).rms_after_dph, good.runs.at(1).rms_before_dph);
  }
  EXPECT_EQ(useful, 10);
  EXPECT_LE(useless, 1);
}

TEST(Additions, OfAUselessExpressionAreRefused) {
  const Model model = incomplete(kComplete);
  int accepted = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const fogcomp::EffectChange change =
        change_expression(model.terms, "late = lag(dTdt^2, ?tau[60,6000])");
    accepted += add_effect(model, change, runs_of(truth(), {seed}), {}, {}).accepted ? 1 : 0;
  }
  EXPECT_LE(accepted, 1);  // kLeastGain lets about one in 100 pass
}

}  // namespace
