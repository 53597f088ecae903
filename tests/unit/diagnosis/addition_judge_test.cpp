#include "diagnosis/addition_judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "unit/fit/simulated_addition.hpp"

namespace fogcomp::diagnosis {
namespace {

// A run on a shaker that stands still, or that runs half of the time. `dph_per_grms2`: drift.
compare::RunInBlocks shaken_run(double grms, double dph_per_grms2, std::uint64_t seed) {
  recording::Recording recording =
      fog::test::recording_of(fog::test::truth(), fog::test::kAdditionNoise, seed);
  std::mt19937_64 random(seed + 100);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    const double shaken = i / 100 % 2 == 1 ? grms : 0;
    recording[fog::Input::vibration].push_back(std::abs(shaken + 0.01 * normal(random)));
    recording.rate_dph[i] += dph_per_grms2 * std::pow(recording[fog::Input::vibration][i], 2);
  }
  return compare::run_in_blocks(recording, 10);
}

TriedAddition described(const JudgingRuns& runs) {
  const model::Model model = fog::test::incomplete(fog::test::kComplete);
  return AdditionJudge(model, runs, false).of_description({{"vibration"}, "", false, false});
}

TEST(AdditionJudge, LetsARunJudgeADescriptionIfTheOthersDetermineIt) {
  JudgingRuns runs{fog::test::runs_of(fog::test::truth(), {}), {}};
  runs.training.runs = {shaken_run(2, 0.05, 1), shaken_run(2, 0.05, 2)};
  EXPECT_TRUE(described(runs).accepted) << described(runs).reason;
  // of the other sign, but smaller: it still lowers the error of both together
  runs.training.runs = {shaken_run(2, 0.05, 1), shaken_run(1.8, -0.05, 2)};
  const TriedAddition refused = described(runs);
  EXPECT_FALSE(refused.accepted);
  EXPECT_NE(refused.reason.find("when that run is left out"), std::string::npos) << refused.reason;
}

// Nobody shook the gyro in the second run: what that run says of vibration is noise.
TEST(AdditionJudge, DoesNotLetTheOnlyRunThatShowsADescriptionJudgeIt) {
  JudgingRuns runs{fog::test::runs_of(fog::test::truth(), {}), {}};
  runs.training.runs = {shaken_run(2, 0.05, 1), shaken_run(0, 0.05, 2)};
  const TriedAddition trial = described(runs);
  EXPECT_TRUE(trial.accepted) << trial.reason;
}

}  // namespace
}  // namespace fogcomp::diagnosis
