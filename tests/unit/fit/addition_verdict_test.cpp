#include "fit/addition_verdict.hpp"

#include <gtest/gtest.h>

#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

// An addition that takes a model from 0.024 to 0.018 deg/h, out of sample as well.
Addition helpful(bool within_runs = true) {
  Addition after;
  after.model = fog::test::truth();
  after.changed = {0};
  after.fitted_before_dph = 0.024;
  after.fitted_after_dph = 0.018;
  after.out_of_sample = OutOfSample{0.026, 0.019, 70, within_runs, "on stretches"};
  after.soak_sigma_before_dph = 0.013;
  after.soak_sigma_after_dph = 0.015;
  return after;
}

bool is_accepted(Addition after) {
  decide(fog::test::truth(), false, after);
  EXPECT_FALSE(after.reason.empty());
  return after.accepted;
}

TEST(AdditionVerdict, RefusesTermsThatNearlyCancelOnTheseRuns) {
  EXPECT_TRUE(is_accepted(helpful()));
  Addition after = helpful();
  after.soak_sigma_after_dph = 0.17;
  EXPECT_FALSE(is_accepted(after));
  // The model was as uncertain before.
  after.soak_sigma_before_dph = 0.17;
  EXPECT_TRUE(is_accepted(after));
  // Another run has judged.
  after = helpful(false);
  after.soak_sigma_after_dph = 0.17;
  EXPECT_TRUE(is_accepted(after));
}

TEST(AdditionVerdict, RefusesWhatTheRunsDoNotDetermineInASoak) {
  Addition after = helpful();
  after.model.uncertain = model::Model::Uncertain{0.9, 0.5, false};
  EXPECT_FALSE(is_accepted(after));
  // A recording that began late: it holds in these rows, and export refuses it.
  after.model.uncertain->at_power_on = true;
  EXPECT_TRUE(is_accepted(after));
}

}  // namespace
}  // namespace fogcomp::fit
