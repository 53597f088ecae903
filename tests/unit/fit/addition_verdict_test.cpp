#include "fit/addition_verdict.hpp"

#include <gtest/gtest.h>

#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

OutOfSample judged(double gain) {
  return {0.026, 0.019, {gain, 2.2}, {}, true, "on stretches"};
}

Addition addition(const OutOfSample& out_of_sample) {
  Addition after;
  after.model = fog::test::truth();
  after.changed = {0};
  after.out_of_sample = out_of_sample;
  return after;
}

bool is_accepted(Addition after) {
  decide(after);
  EXPECT_FALSE(after.reason.empty());
  return after.accepted;
}

TEST(AdditionVerdict, GainThatChanceGivesOnceIn100Times_Accepted) {
  EXPECT_TRUE(is_accepted(addition(judged(5))));
  EXPECT_FALSE(is_accepted(addition(judged(4))));
  EXPECT_FALSE(is_accepted(addition(judged(-5))));
}

TEST(AdditionVerdict, HarmFarFromTheRowsFitted_Refused) {
  Addition after = addition(judged(5));
  OutOfSample worse = judged(-4);
  worse.rms_after_dph = 0.03;
  worse.promise = {123, 100, 100};  // as uncertain as it is
  after.far = {worse, judged(3)};
  EXPECT_TRUE(is_accepted(after));
  after.far[0].promise.squares = 124;
  EXPECT_FALSE(is_accepted(after));
  after.far[0].rms_after_dph = 0.02;  // and better than before all the same
  EXPECT_TRUE(is_accepted(after));
}

TEST(AdditionVerdict, PartThatBringsNothing_Refused) {
  Addition after = addition(judged(5));
  after.parts = {{"aging", judged(5), judged(5)}, {"shupe", judged(5), {}}};
  EXPECT_TRUE(is_accepted(after));
  after.parts[1].beside = judged(4);
  EXPECT_FALSE(is_accepted(after));
}

TEST(AdditionVerdict, WholeModelWorseOnTheHoldouts_Refused) {
  Addition after = addition(judged(5));
  after.whole = judged(-5);
  after.whole->rms_after_dph = 0.027;
  EXPECT_FALSE(is_accepted(after));
}

}  // namespace
}  // namespace fogcomp::fit
