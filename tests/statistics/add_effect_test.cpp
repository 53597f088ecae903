// Error rates of the decision on an addition.
#include "fit/add_effect.hpp"

#include <gtest/gtest.h>

#include "support/chance.hpp"
#include "support/typical_effects.hpp"
#include "unit/fit/simulated_addition.hpp"

namespace {

using namespace fog::test;
using fogcomp::fit::Addition;
using fogcomp::model::Model;

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
                    result.model.terms[2].coefficients_dph[0].value /
                        result.model.terms[2].coefficients_dph[0].sigma,
                    result.reason.c_str());
      }
    }
    std::printf("%d of 20 accepted\n", accepted);
    EXPECT_GE(accepted, size > 1 ? 20 : 15);
  }
}

// Results for useless additions.
struct Useless {
  int tried = 0;
  int accepted = 0;
  int above_zero = 0;  // gains; of a judge that knows the data which it judges by, all

  void count(const Addition& addition) {
    ++tried;
    accepted += addition.accepted ? 1 : 0;
    above_zero += addition.out_of_sample->score.gain > 0 ? 1 : 0;
    if (addition.accepted) std::printf("%s\n", addition.reason.c_str());
    EXPECT_EQ(addition.model.history.back().forced, !addition.accepted);
  }
};

// The claims (OutOfSample): one in 100 reaches kMinChi2Drop, and values are about -1 +- 2, so less
// than one in three is above 0. A correct judge fails this less than once in 50 times. With 60
// trials a judge that accepts 10 % (20 %) passes 14 (0) times in 100, and one with two in three
// values above 0 less than once.
void expect_useless(const Useless& useless) {
  std::printf("%d of %d useless additions accepted, %d gains above 0\n", useless.accepted,
              useless.tried, useless.above_zero);
  EXPECT_GE(probability_of_at_least(useless.accepted, useless.tried, 0.01), 0.01);
  EXPECT_GE(probability_of_at_least(useless.above_zero, useless.tried, 1.0 / 3), 0.01);
}

TEST(Additions, OfAUselessEffectAreRefused) {
  Useless useless;
  for (const char* const effect :
       {"thermal_hysteresis:radius=5", "thermal_lag", "warm_up", "polarization_ripple",
        "temperature_rate_product", "bias_temperature:order=4"}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      useless.count(add(kComplete, effect, truth(), {seed}));
    }
  }
  expect_useless(useless);
}

TEST(Additions, AreJudgedRightlyOnHoldouts) {
  int useful = 0;
  Useless useless;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const std::vector<fogcomp::runs::Run> holdouts{run_of(truth(), 100 + seed)};
    const Addition good =
        add("bias,bias_temperature:order=3", "temperature_rate", truth(), {seed}, holdouts);
    if (good.accepted) ++useful;
    useless.count(add(kComplete, "thermal_hysteresis", truth(), {seed}, holdouts));
    EXPECT_LT(good.runs.at(1).rms_after_dph, good.runs.at(1).rms_before_dph);
  }
  EXPECT_EQ(useful, 10);
  expect_useless(useless);
}

TEST(Additions, OfAUselessExpressionAreRefused) {
  const Model model = incomplete(kComplete);
  Useless useless;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const fogcomp::fit::EffectChange change =
        fogcomp::fit::change_expression(model.terms, "late = lag(dTdt^2, ?tau[60,6000])");
    useless.count(fogcomp::fit::add_effect(model, change, runs_of(truth(), {seed}), {}));
  }
  expect_useless(useless);
}

}  // namespace
