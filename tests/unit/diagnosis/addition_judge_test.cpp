#include "diagnosis/addition_judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "unit/fit/simulated_addition.hpp"

namespace fogcomp::diagnosis {
namespace {

// A run on a shaker that stands still, or that runs half of the time. `dph_per_grms2`: drift.
runs::Run shaken_run(double grms, double dph_per_grms2, std::uint64_t seed) {
  recording::Recording recording =
      fog::test::recording_of(fog::test::truth(), fog::test::kAdditionNoise, seed);
  std::mt19937_64 random(seed + 100);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    const double shaken = i / 100 % 2 == 1 ? grms : 0;
    recording[fog::Input::vibration].push_back(std::abs(shaken + 0.01 * normal(random)));
    recording.rate_dph[i] += dph_per_grms2 * std::pow(recording[fog::Input::vibration][i], 2);
  }
  return runs::run_of(recording, {10});
}

TriedAddition described(const runs::Runs& runs) {
  const model::Model model = fog::test::incomplete(fog::test::kComplete);
  return AdditionJudge(model, runs, false)({{"vibration"}, "", false, false});
}

TEST(AdditionJudge, LetsARunJudgeADescriptionIfTheOthersDetermineIt) {
  runs::Runs runs = fog::test::runs_of(fog::test::truth(), {});
  runs.training = {shaken_run(2, 0.05, 1), shaken_run(2, 0.05, 2)};
  EXPECT_TRUE(described(runs).accepted) << described(runs).reason;
  // of the other sign, but smaller: it still lowers the error of both together
  runs.training = {shaken_run(2, 0.05, 1), shaken_run(1.8, -0.05, 2)};
  EXPECT_FALSE(described(runs).accepted);
}

// Nobody shook the gyro in the second run: what that run says of vibration is noise.
TEST(AdditionJudge, DoesNotLetTheOnlyRunThatShowsADescriptionJudgeIt) {
  runs::Runs runs = fog::test::runs_of(fog::test::truth(), {});
  runs.training = {shaken_run(2, 0.05, 1), shaken_run(0, 0.05, 2)};
  const TriedAddition trial = described(runs);
  EXPECT_TRUE(trial.accepted) << trial.reason;
}

// A run with `drift_dph`(recording, row) beside the drift of truth().
runs::Runs run_with(
    const std::function<double(const recording::Recording&, std::size_t)>& drift_dph) {
  recording::Recording recording =
      fog::test::recording_of(fog::test::truth(), fog::test::kAdditionNoise, 1);
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    recording.rate_dph[i] += drift_dph(recording, i);
  }
  runs::Runs runs = fog::test::runs_of(fog::test::truth(), {});
  runs.training = {runs::run_of(recording, {10})};
  return runs;
}
// The same with 0.05 deg/h sin(T) times `factor`(recording, row).
runs::Runs run_with_sine(
    const std::function<double(const recording::Recording&, std::size_t)>& factor) {
  return run_with([&](const recording::Recording& r, std::size_t i) {
    return 0.05 * std::sin(r.temperature_degc[i]) * factor(r, i);
  });
}

const AdditionRequest kSine{{}, "x = sin(T)", false, false};

TEST(AdditionJudge, RefusesADescriptionThatContradictsItselfInTheOtherDirection) {
  const auto judged = [](double in_cooling) {
    const runs::Runs runs = run_with_sine([&](const recording::Recording& r, std::size_t i) {
      const bool cools = i > 0 && r.temperature_degc[i] < r.temperature_degc[i - 1];
      return cools ? in_cooling : 1;
    });
    const model::Model model = fog::test::incomplete(fog::test::kComplete);
    return AdditionJudge(model, runs, false)(kSine);
  };
  EXPECT_TRUE(judged(1).accepted) << judged(1).reason;
  const TriedAddition refused = judged(0.1);
  EXPECT_FALSE(refused.accepted);
  EXPECT_LT(refused.rms_after_dph, refused.rms_before_dph) << "stretches do not show it";
  EXPECT_NE(refused.reason.find("on cooling"), std::string::npos) << refused.reason;
}

// Something that begins in the warm: a power of the temperature follows it in part.
TEST(AdditionJudge, RightForm_LeavesLessThanOneThatFollowsIt) {
  const runs::Runs runs = run_with([](const recording::Recording& r, std::size_t i) {
    return 0.01 * std::max(0.0, r.temperature_degc[i] - 20);
  });
  const model::Model model = fog::test::incomplete(fog::test::kComplete);
  AdditionJudge judge(model, runs, false);
  const TriedAddition kink = judge({{}, "kink = max(T-20,0)", false, false});
  EXPECT_TRUE(kink.accepted) << kink.reason;
  const TriedAddition power = judge({{}, "power = T^5", false, false});
  EXPECT_LT(kink.rms_after_dph, 0.7 * power.rms_after_dph);
}

TEST(AdditionJudge, RefusesWhatHarmsInThirdsOfTheRun) {
  const auto judged = [](double in_the_last_third) {
    const runs::Runs runs = run_with_sine([&](const recording::Recording& r, std::size_t i) {
      return i >= 2 * r.rows() / 3 ? in_the_last_third : 1;
    });
    const model::Model model = fog::test::incomplete(fog::test::kComplete);
    return AdditionJudge(model, runs, false)(kSine);
  };
  EXPECT_TRUE(judged(1).accepted) << judged(1).reason;
  const TriedAddition refused = judged(-0.45);
  EXPECT_FALSE(refused.accepted);
  EXPECT_TRUE(refused.score.improves()) << "stretches do not show it";
  EXPECT_NE(refused.reason.find("the last third of every run"), std::string::npos)
      << refused.reason;
}

}  // namespace
}  // namespace fogcomp::diagnosis
