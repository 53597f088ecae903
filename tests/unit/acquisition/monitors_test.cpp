#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "core/acquisition/rate_monitor.hpp"
#include "core/acquisition/sequence_monitor.hpp"
#include "core/acquisition/stuck_monitor.hpp"
#include "core/acquisition/temperature_monitor.hpp"

namespace {

using fog::Rate;
using fog::Status;
using fog::Temperature;

constexpr std::uint32_t kPeriodUs = 5000;
constexpr int kSecond = 200;  // samples
constexpr std::int32_t kRawPerDegPerS = 3600 * 1024;

Rate deg_per_s(double rate) {
  return Rate::from_raw(static_cast<std::int32_t>(rate * kRawPerDegPerS));
}
Temperature degc(double temperature) {
  return Temperature::from_raw(static_cast<std::int32_t>(temperature * 65536));
}

TEST(SequenceMonitor, TimeIsRightAfterLostRepeatedAndReorderedSamples) {
  fog::SequenceMonitor monitor;
  std::uint32_t time = 0;
  const auto send = [&](std::uint16_t sequence) {
    const auto verdict = monitor.judge(sequence);
    if (!verdict.late) time += verdict.missing + 1;
    return any(verdict.status, Status::sequence_gap);
  };
  EXPECT_FALSE(send(65533));
  EXPECT_FALSE(send(65534));
  EXPECT_TRUE(send(1));  // 65535 and 0 are lost
  EXPECT_EQ(time, 5U);
  EXPECT_TRUE(send(1));  // twice
  EXPECT_TRUE(send(3));
  EXPECT_TRUE(send(2));  // out of order
  EXPECT_FALSE(send(4));
  EXPECT_EQ(time, 8U);
}

TEST(SequenceMonitor, ADemodulatorThatCountsAnewIsFollowedAfterEightSamples) {
  fog::SequenceMonitor monitor;
  std::uint32_t time = 0;
  const auto send = [&](std::uint16_t sequence) {
    const auto verdict = monitor.judge(sequence);
    if (!verdict.late) time += verdict.missing + 1;
    return any(verdict.status, Status::sequence_gap);
  };
  for (std::uint16_t i = 1000; i < 1100; ++i) send(i);
  for (std::uint16_t i = 0; i < 8; ++i) EXPECT_TRUE(send(i)) << i;
  EXPECT_FALSE(send(8));
  EXPECT_EQ(time, 109U);
}

TEST(StuckMonitor, CallsConstantAndTogglingCountsStuckAndNothingElse) {
  for (const std::int32_t toggle : {0, 1, -1}) {
    for (const std::int32_t at : {0, 12345, INT32_MAX, INT32_MIN}) {
      fog::StuckMonitor monitor(100);
      if ((at == INT32_MAX && toggle > 0) || (at == INT32_MIN && toggle < 0)) continue;
      for (int i = 1; i < 100; ++i) {
        EXPECT_FALSE(monitor.judge(at + toggle * (i % 2))) << at << " " << i;
      }
      for (int i = 0; i < 1000; ++i) EXPECT_TRUE(monitor.judge(at)) << at;
      EXPECT_FALSE(monitor.judge(at == INT32_MAX ? at - 2 : at + 2));
    }
  }
  fog::StuckMonitor monitor(100);
  for (int i = 0; i < 10000; ++i) EXPECT_FALSE(monitor.judge(i % 3)) << i;
}

TEST(RateMonitor, RangeIsSetAt97AndAHalfAndClearedBelow92AndAHalfFor50Milliseconds) {
  for (const double sign : {1.0, -1.0}) {
    fog::RateMonitor monitor(deg_per_s(400), kPeriodUs);
    const auto flagged = [&](double rate) {
      return any(monitor.judge(deg_per_s(sign * rate), true, 1), Status::rate_out_of_range);
    };
    EXPECT_FALSE(flagged(380));
    EXPECT_FALSE(flagged(389.9));
    EXPECT_TRUE(flagged(390.1));
    for (int i = 0; i < 100; ++i) EXPECT_TRUE(flagged(370.1));  // between the two
    for (int i = 1; i < 10; ++i) EXPECT_TRUE(flagged(369.9)) << i;
    EXPECT_TRUE(flagged(371));  // begins anew
    for (int i = 1; i < 10; ++i) EXPECT_TRUE(flagged(369.9)) << i;
    EXPECT_FALSE(flagged(369.9));
  }
}

TEST(RateMonitor, ASpikeIsRefusedAndTheSampleAfterItAccepted) {
  fog::RateMonitor monitor(deg_per_s(500), kPeriodUs);
  EXPECT_EQ(monitor.judge(deg_per_s(1), true, 1), Status::none);
  EXPECT_EQ(monitor.judge(deg_per_s(102), true, 1), Status::rate_jump);
  EXPECT_EQ(monitor.judge(deg_per_s(1), true, 1), Status::none);
  EXPECT_EQ(monitor.judge(deg_per_s(100), true, 1), Status::none);
}

TEST(RateMonitor, ANewSteadyRateIsAcceptedAsSoonAsItCanHaveBeenReached) {
  fog::RateMonitor monitor(deg_per_s(500), kPeriodUs);
  EXPECT_EQ(monitor.judge(deg_per_s(0), true, 1), Status::none);
  for (int i = 1; i < 4; ++i) EXPECT_EQ(monitor.judge(deg_per_s(399), true, 1), Status::rate_jump);
  EXPECT_EQ(monitor.judge(deg_per_s(399), true, 1), Status::none);
  EXPECT_EQ(monitor.judge(deg_per_s(-200), true, 6), Status::none);  // five samples were lost
}

TEST(RateMonitor, ARateThatLeapsToAndFroIsNeverBelieved) {
  fog::RateMonitor monitor(deg_per_s(500), kPeriodUs);
  EXPECT_EQ(monitor.judge(deg_per_s(0), true, 1), Status::none);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(monitor.judge(deg_per_s(i % 2 == 0 ? 300 : -300), true, 1), Status::rate_jump) << i;
  }
}

TEST(RateMonitor, AFullScaleStepIsNoJumpWhereASampleLastsHalfASecond) {
  fog::RateMonitor monitor(deg_per_s(500), 500'000);
  EXPECT_EQ(monitor.judge(deg_per_s(-480), true, 1), Status::none);
  EXPECT_EQ(monitor.judge(deg_per_s(480), true, 1), Status::none);
}

class TemperatureMonitorTest : public testing::Test {
 protected:
  Status send(double temperature, int samples = 1) {
    Status status{};
    for (int i = 0; i < samples; ++i) status = monitor_.judge(degc(temperature), true, 1);
    return status;
  }
  fog::TemperatureMonitor monitor_{kPeriodUs};
};

constexpr Status kJump = Status::temperature_invalid | Status::temperature_jump;
constexpr Status kFrozen = Status::temperature_invalid | Status::temperature_frozen;

TEST_F(TemperatureMonitorTest, AJumpIsRefusedUntilACoilCanBeThere) {
  EXPECT_EQ(send(20), Status::none);
  EXPECT_EQ(send(22), Status::none);
  EXPECT_EQ(send(34), kJump);
  EXPECT_EQ(send(22), Status::none);
  EXPECT_EQ(send(34, 10 * kSecond - 1), kJump);
  EXPECT_EQ(send(34), Status::none);
}

TEST_F(TemperatureMonitorTest, ReadingsThatLeapToAndFroAreNeverBelieved) {
  EXPECT_EQ(send(20), Status::none);
  for (int i = 0; i < 600 * kSecond; ++i) EXPECT_EQ(send(i % 2 == 0 ? -60 : 110), kJump) << i;
  EXPECT_EQ(send(21), Status::none);
}

TEST_F(TemperatureMonitorTest, ThePowerOnReadingOfADs18b20IsNeverTakenUnlessApproached) {
  EXPECT_EQ(send(85), kJump);
  EXPECT_EQ(send(20), Status::none);
  EXPECT_EQ(send(85, 600 * kSecond), kJump);
  EXPECT_EQ(send(84.5), Status::none);
  EXPECT_EQ(send(85), Status::none);
  EXPECT_EQ(send(85, kSecond), Status::none);
}

TEST_F(TemperatureMonitorTest, MissingAndImpossibleReadingsAreInvalid) {
  EXPECT_EQ(send(131), Status::temperature_invalid);
  EXPECT_EQ(send(-70.1), Status::temperature_invalid);
  EXPECT_EQ(monitor_.judge(degc(20), false, 1), Status::temperature_invalid);
  EXPECT_EQ(send(20), Status::none);
}

// 1 degC/min in steps of 1/16 degC, then nothing.
TEST_F(TemperatureMonitorTest, ACoarseSensorThatStopsWithinARampIsFrozenAfterTwoMinutes) {
  double reading = 20;
  for (int i = 0; i < 300; ++i) {
    EXPECT_EQ(send(reading += 1.0 / 16, 3 * kSecond + 150), Status::none);
  }
  EXPECT_EQ(send(reading, (120 - 4) * kSecond), Status::none);
  EXPECT_EQ(send(reading, 4 * kSecond), kFrozen);
  EXPECT_EQ(send(reading + 1.0 / 16), Status::none);  // it lives
}

TEST_F(TemperatureMonitorTest, ASensorThatShowsItsNoiseIsFrozenAfterAMinute) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i)
    EXPECT_EQ(send(20 + 0.001 * static_cast<double>(random() % 101U)), Status::none);
  const double last = 20.03;
  EXPECT_EQ(send(last, 60 * kSecond), Status::none);
  EXPECT_EQ(send(last), kFrozen);
}

// A soak: the readings toggle, then stand in the middle of a step for hours.
TEST_F(TemperatureMonitorTest, ACoarseSensorMayStandForHours) {
  for (int i = 0; i < 600; ++i) EXPECT_EQ(send(20 + (i % 3 == 0) / 16.0, kSecond), Status::none);
  EXPECT_EQ(send(20, 6 * 3600 * kSecond), Status::none);
}

}  // namespace
