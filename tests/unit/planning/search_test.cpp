#include "planning/search.hpp"

#include <gtest/gtest.h>

#include "model/effect_list.hpp"
#include "model/model.hpp"
#include "simulation/embedded_files.hpp"
#include "simulation/programme.hpp"
#include "support/input_error.hpp"

namespace fogcomp::planning {
namespace {

constexpr OperatingBox kUse{{-40, 60}, {-1, 1}, 0};
constexpr OperatingBox kChamber{{-40, 85}, {-3, 3}, 0};

Question question(const std::string& effects, const OperatingBox& use = kUse) {
  Question question;
  for (const model::EffectTerm& term : model::parse_effects(effects)) {
    question.terms.push_back(model::of_typical_size(term));
  }
  question.white_dph_rthz = 0.07;
  question.flicker_dph = 0.002;
  question.use = use;
  return question;
}

simulation::Programme programme(const std::string& text) {
  return simulation::parse_profile(text, "test", 1);
}

simulation::Programme ready_made(const std::string& name) {
  return programme(simulation::find_text(name, simulation::ready_made_profiles(), "profile"));
}

double visible_dph(const Foresight& foresight, const simulation::Programme& programme,
                   const std::string& effect) {
  for (const VisibleSize& size : foresight.visible(programme)) {
    if (size.effect == effect) return size.visible_dph;
  }
  ADD_FAILURE() << effect << " is not said";
  return 0;
}

TEST(Foresight, MoreHours_LessNoise) {
  Question white = question("bias,bias_temperature,temperature_rate");
  white.flicker_dph = 0;  // which no hours average out
  const Foresight foresight(white);
  const std::string cycle =
      "ramp to -40 degC at 1 degC/min\nsoak 1 h\nramp to 60 degC at 1 degC/min\nsoak 1 h\n";
  const double once = foresight.expect(programme(cycle)).error.noise_dph;
  const double four_times =
      foresight.expect(programme("repeat 4\n" + cycle + "end\n")).error.noise_dph;
  EXPECT_LT(four_times, 0.7 * once);
  EXPECT_GT(four_times, 0.3 * once);
}

TEST(Foresight, ASoak_DoesNotShowTheRateTerm) {
  const Foresight foresight(question("bias,bias_temperature"));
  const double soak = visible_dph(foresight, programme("soak 10 h\n"), "temperature_rate");
  const double ramps = visible_dph(foresight, ready_made("paper"), "temperature_rate");
  EXPECT_LT(ramps, 0.1 * soak);
}

// The same information by hand: the mean of white noise.
TEST(Foresight, BiasAlone_IsKnownLikeAMean) {
  Question alone = question("bias");
  alone.flicker_dph = 0;
  const Foresight foresight(alone);
  const double hours = 5;
  EXPECT_NEAR(foresight.expect(programme("soak 5 h\n")).error.noise_dph,
              alone.white_dph_rthz / std::sqrt(3600 * hours), 1e-5);
}

TEST(Foresight, EffectWithoutItsInput_IsRefused) {
  EXPECT_THROW(Foresight{question("bias,scale_factor")}, InputError);
  EXPECT_THROW(Foresight{question("bias,bias_step")}, InputError);
}

TEST(Search, Plan_BeatsThePapersProgrammeOfEqualLength) {
  const Foresight foresight(question("bias,bias_temperature,temperature_rate,shupe"));
  const simulation::Programme paper = ready_made("paper");
  const Plan plan = search_plan(foresight, {kChamber, paper.duration_s() / 3600, 1});
  EXPECT_LT(plan.expectation.error.sigma_dph(), 0.9 * foresight.expect(paper).error.sigma_dph());
}

TEST(Search, Plan_LastsItsHoursWithinTheChamber) {
  const Foresight foresight(question("bias,bias_temperature,temperature_rate"));
  for (const double hours : {0.5, 3.0}) {
    const Plan plan = search_plan(foresight, {kChamber, hours, 1});
    const simulation::Programme programme =
        simulation::parse_profile(profile_text(plan), "plan", 1);
    EXPECT_NEAR(programme.duration_s() / 3600, hours, 0.02);
    double minutes = 0;
    double now_degc = plan.start_degc;
    for (const Step& step : plan.steps) {
      minutes += step.minutes(now_degc);
      now_degc = step.to_degc;
    }
    EXPECT_NEAR(minutes / 60, hours, 0.02);
    for (const simulation::Leg& leg : programme.legs) {
      EXPECT_GE(leg.to_degc, -40);
      EXPECT_LE(leg.to_degc, 60);
      EXPECT_LE(std::abs(leg.to_degc - leg.from_degc) / (leg.end_s - leg.start_s), 3.001 / 60);
    }
    EXPECT_EQ(plan.sigma_after_dph.size(), plan.steps.size());
    EXPECT_EQ(plan.sigma_after_dph.back(), plan.expectation.error.sigma_dph());
  }
}

TEST(Search, Seed_DecidesThePlan) {
  const Foresight foresight(question("bias,temperature_rate"));
  const auto planned = [&](std::uint64_t seed) {
    return profile_text(search_plan(foresight, {kChamber, 3, seed}));
  };
  EXPECT_EQ(planned(1), planned(1));
  EXPECT_NE(planned(1), planned(2));
}

TEST(Search, RateTable_TurnsForAScaleFactor) {
  OperatingBox use = kUse;
  use.rate_dps = 100;
  OperatingBox chamber = kChamber;
  chamber.rate_dps = 200;
  const Foresight foresight(question("bias,scale_factor", use));
  const Plan plan = search_plan(foresight, {chamber, 2, 1});
  EXPECT_NE(profile_text(plan).find("100 deg/s"), std::string::npos) << profile_text(plan);
}

}  // namespace
}  // namespace fogcomp::planning
