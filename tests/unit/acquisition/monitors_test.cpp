#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "core/acquisition/extension_monitor.hpp"
#include "core/acquisition/rate_monitor.hpp"
#include "core/acquisition/reading_monitor.hpp"
#include "core/acquisition/sample_rate_monitor.hpp"
#include "core/acquisition/sequence_monitor.hpp"
#include "core/acquisition/stuck_monitor.hpp"

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
    return has_any(verdict.status, Status::sequence_gap);
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
    return has_any(verdict.status, Status::sequence_gap);
  };
  for (std::uint16_t i = 1000; i < 1100; ++i) send(i);
  for (std::uint16_t i = 0; i < 8; ++i) EXPECT_TRUE(send(i)) << i;
  EXPECT_FALSE(send(8));
  EXPECT_EQ(time, 109U);
}

// spec/samples.md.
TEST(SequenceMonitor, AStepByHalfTheCircleIsLossAndByOneMoreIsLate) {
  fog::SequenceMonitor loss;
  loss.judge(0);
  const auto lost = loss.judge(32768);
  EXPECT_FALSE(lost.late);
  EXPECT_EQ(lost.missing, 32767U);
  EXPECT_EQ(lost.status, Status::sequence_gap);
  fog::SequenceMonitor behind;
  EXPECT_EQ(behind.judge(0).status, Status::none);
  const auto late = behind.judge(32769);
  EXPECT_TRUE(late.late);
  EXPECT_EQ(late.missing, 0U);
  EXPECT_EQ(behind.judge(1).status, Status::none) << "time stood";
}

TEST(SequenceMonitor, LateSamplesAreARestartOnlyEightInARow) {
  fog::SequenceMonitor monitor;
  monitor.judge(1000);
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 7; ++i) EXPECT_TRUE(monitor.judge(10).late);
    EXPECT_FALSE(monitor.judge(static_cast<std::uint16_t>(1001 + round)).late);
  }
}

// Without a clock nobody can say whether samples were lost or the numbers have leapt.
TEST(SequenceMonitor, NumbersAlone_ManyMissing_Doubtful) {
  const auto doubtful_of = [](std::uint32_t missing, int every, bool clock) {
    fog::SequenceMonitor monitor(kPeriodUs);
    std::uint32_t sequence = 0;
    int doubtful = 0;
    for (int i = 0; i < 20'000; ++i) {
      sequence += 1 + (i % every == every - 1 ? missing : 0);
      doubtful +=
          monitor.judge(static_cast<std::uint16_t>(sequence), {clock, sequence * 5}).doubtful;
    }
    return doubtful;
  };
  EXPECT_EQ(doubtful_of(1, 60, false), 0) << "a line that loses 1.6 %";
  EXPECT_GT(doubtful_of(1, 40, false), 0) << "2.4 %";
  EXPECT_EQ(doubtful_of(40, 15'000, false), 0) << "0.2 s at once";
  EXPECT_EQ(doubtful_of(41, 15'000, false), 1);
  EXPECT_EQ(doubtful_of(25, 200, false), 50) << "with every other leap";
  EXPECT_EQ(doubtful_of(25, 200, true), 0);
  EXPECT_EQ(doubtful_of(30'000, 10'000, true), 0);
}

TEST(SequenceMonitor, OneFrameAgainAndAgain_WithoutAClock_Doubtful) {
  fog::SequenceMonitor monitor(kPeriodUs);
  bool doubtful = false;
  for (int i = 0; i < 100; ++i) doubtful = doubtful || monitor.judge(7).doubtful;
  EXPECT_TRUE(doubtful);
}

// The board's clock beside the sequence: at 200 Hz, from just below where it wraps.
class TimedSequenceTest : public testing::Test {
 protected:
  fog::SequenceMonitor::Verdict send(std::uint32_t sequence, std::uint32_t passed_ms) {
    now_ms_ += passed_ms;
    return monitor_.judge(static_cast<std::uint16_t>(sequence), {true, now_ms_});
  }
  fog::SequenceMonitor monitor_{kPeriodUs};
  std::uint32_t now_ms_ = 0U - 100U;
};

TEST_F(TimedSequenceTest, AnOutageOfAnyLengthIsTimeThatPassed) {
  std::uint32_t sequence = 65000;
  send(sequence, 0);
  for (const std::uint32_t lost :
       {1U, 300U, 32767U, 32768U, 40000U, 65535U, 65536U, 66000U, 200'000U, 1'000'000U}) {
    const std::uint32_t passed_ms = (lost + 1) * 5;
    const auto verdict = send(sequence += lost + 1, passed_ms + lost / 4000);  // by 0.005 % slow
    EXPECT_EQ(verdict.missing, lost);
    EXPECT_FALSE(verdict.late) << lost;
    EXPECT_EQ(verdict.status, Status::sequence_gap) << lost;
    EXPECT_EQ(send(++sequence, 5).status, Status::none) << lost;
  }
}

TEST(SequenceMonitor, TimeOfASampleBeforeAReset_GapIsTheClocks) {
  fog::SequenceMonitor monitor(kPeriodUs);
  monitor.judge(65000, {});
  monitor.set_newest_time({true, 1000});
  EXPECT_EQ(monitor.judge(65011, {true, 1000 + 11 * 5}).missing, 10U);
  EXPECT_EQ(monitor.judge(65012, {true, 1055 + (65537 * 5)}).missing, 65536U);
}

TEST(SequenceMonitor, Outage_LongerThanItCounts_HeldAtItsLongest) {
  fog::SequenceMonitor monitor(1000);
  monitor.judge(0, {true, 0});
  EXPECT_EQ(monitor.judge(1, {true, 4'000'000'000U}).missing, 1U << 30U);
  EXPECT_EQ(monitor.judge(2, {true, 4'000'000'001U}).status, Status::none);
}

TEST_F(TimedSequenceTest, ADemodulatorThatCountsAnewIsFollowedAtOnceAndTimeIsTheClocks) {
  for (const std::uint32_t from : {0U, 20'000U, 40'000U, 59'000U}) {
    fog::SequenceMonitor monitor(kPeriodUs);
    monitor.judge(50'000, {true, now_ms_});
    const auto verdict = monitor.judge(static_cast<std::uint16_t>(from), {true, now_ms_ + 50});
    EXPECT_EQ(verdict.missing, 9U) << from;
    EXPECT_FALSE(verdict.late) << from;
    EXPECT_EQ(verdict.status, Status::sequence_gap) << from;
    const auto next = monitor.judge(static_cast<std::uint16_t>(from + 1), {true, now_ms_ + 55});
    EXPECT_EQ(next.status, Status::none) << from;
  }
}

TEST_F(TimedSequenceTest, OneThatStoodStillForAWhileIsTimeThatPassed) {
  send(7, 0);
  const auto verdict = send(8, 10'000);
  EXPECT_EQ(verdict.missing, 1999U);
  EXPECT_EQ(verdict.status, Status::sequence_gap);
}

TEST_F(TimedSequenceTest, SamplesThatWaitedToBeReadAreNeitherLostNorLate) {
  send(65530, 0);
  send(65531, 200);  // the board was busy
  for (std::uint32_t i = 65532; i < 65570; ++i) EXPECT_EQ(send(i, 0).status, Status::none) << i;
  EXPECT_TRUE(send(65569, 0).late) << "repeated";
  EXPECT_TRUE(send(65560, 0).late);
  EXPECT_EQ(send(65570, 5).missing, 0U);
}

// 64 samples and 3 % of what the clock says.
TEST_F(TimedSequenceTest, ToleratesWhatABufferHoldsAndARateErrorOfThreePercent) {
  const auto missing = [&](std::uint32_t sequence, std::uint32_t passed_ms) {
    fog::SequenceMonitor monitor(kPeriodUs);
    monitor.judge(0, {true, 5});
    return monitor.judge(static_cast<std::uint16_t>(sequence), {true, 5 + passed_ms}).missing;
  };
  EXPECT_EQ(missing(1 + 64, 5), 64U);
  EXPECT_EQ(missing(1 + 65, 5), 0U) << "counted anew";
  EXPECT_EQ(missing(3200 + 64 + 99, 16'000), 3199U + 64 + 99);
  EXPECT_EQ(missing(3200 + 64 + 100, 16'000), 3199U) << "counted anew";
}

TEST_F(TimedSequenceTest, WithoutATimeOfBothTheSequenceAloneCounts) {
  send(0, 0);
  EXPECT_EQ(monitor_.judge(100).missing, 99U);
  EXPECT_EQ(send(300, 1'000'000).missing, 199U);
  EXPECT_TRUE(monitor_.judge(299).late);
}

TEST(SampleRateMonitor, IsOffBeyondTwoPercentWithinTenSecondsAndOnAgainAfterTenMore) {
  for (const double rate_hz : {100.0, 190.0, 195.9, 196.1, 200.0, 203.9, 204.1, 210.0, 400.0}) {
    fog::SampleRateMonitor monitor(kPeriodUs, 50);
    const bool off = std::abs(rate_hz / 200 - 1) > 0.02;
    double time_ms = 4294967295.0 - 7000;  // wraps on the way
    const auto judge = [&](double hz) {
      time_ms += 1000 / hz;
      const auto wrapped = static_cast<std::uint32_t>(static_cast<std::uint64_t>(time_ms));
      return monitor.judge(1, {true, wrapped});
    };
    double flagged_s = 0;
    for (int i = 0; i < 60 * rate_hz; ++i) {
      if (judge(rate_hz) == Status::sample_rate && flagged_s == 0) flagged_s = i / rate_hz;
    }
    EXPECT_EQ(flagged_s > 0, off) << rate_hz;
    EXPECT_LE(flagged_s, 10.1) << rate_hz;
    EXPECT_EQ(judge(rate_hz), off ? Status::sample_rate : Status::none) << rate_hz;
    for (int i = 0; i < 20 * 200; ++i) judge(200);
    EXPECT_EQ(judge(200), Status::none) << rate_hz;
  }
}

TEST(SampleRateMonitor, Part_OfTheTable_IsTheLimit) {
  for (const int part : {50, 100, 200}) {
    for (const bool beyond : {false, true}) {
      fog::SampleRateMonitor monitor(kPeriodUs, static_cast<std::uint32_t>(part));
      const double off = (beyond ? 1.1 : 0.9) / part;
      Status seen = Status::none;
      for (int i = 0; i < 15 * kSecond; ++i) {
        seen |= monitor.judge(1, {true, static_cast<std::uint32_t>(i * 5 * (1 + off))});
      }
      EXPECT_EQ(seen, beyond ? Status::sample_rate : Status::none) << part;
    }
  }
}

TEST(SampleRateMonitor, TwiceTheRateIsFoundWithinHalfASecond) {
  fog::SampleRateMonitor monitor(kPeriodUs, 50);
  std::uint32_t i = 0;
  while (monitor.judge(1, {true, 1000 + i * 5 / 2}) == Status::none && i < 4000) ++i;
  EXPECT_LE(i, 200U);
}

TEST(SampleRateMonitor, LossesRepetitionsAndOutagesAreNoOtherRate) {
  fog::SampleRateMonitor monitor(kPeriodUs, 50);
  std::uint32_t now_ms = 0;
  EXPECT_EQ(monitor.judge(1, {true, now_ms}), Status::none);
  for (const std::uint32_t elapsed : {1U, 100U, 1U, 0U, 4000U, 1U, 131'072U, 1U, 2'000'000U, 1U}) {
    now_ms += 5 * elapsed;
    now_ms -= elapsed / 100;  // a fifth of a percent
    EXPECT_EQ(monitor.judge(elapsed, {true, now_ms}), Status::none) << elapsed;
  }
}

TEST(SampleRateMonitor, KnowsNothingWithoutAClock) {
  fog::SampleRateMonitor monitor(kPeriodUs, 50);
  for (int i = 0; i < 10'000; ++i) EXPECT_EQ(monitor.judge(1, {}), Status::none);
}

TEST(StuckMonitor, IsOffWithALimitOfNone) {
  fog::StuckMonitor monitor({0, 1});
  for (int i = 0; i < 1000; ++i) EXPECT_FALSE(monitor.judge(7));
}

TEST(StuckMonitor, CountsDriftingByAnLsbNowAndThenAreAlive) {
  fog::StuckMonitor monitor({100, 1});
  for (int i = 0; i < 5000; ++i) EXPECT_FALSE(monitor.judge(i / 49)) << i;
  for (int i = 5000; i > 0; --i) EXPECT_FALSE(monitor.judge(i / 49)) << i;
}

TEST(StuckMonitor, CallsConstantAndTogglingCountsStuckAndNothingElse) {
  for (const std::int32_t toggle : {0, 1, -1}) {
    for (const std::int32_t at : {0, 12345, INT32_MAX, INT32_MIN}) {
      fog::StuckMonitor monitor({100, 1});
      if ((at == INT32_MAX && toggle > 0) || (at == INT32_MIN && toggle < 0)) continue;
      for (int i = 1; i < 100; ++i) {
        EXPECT_FALSE(monitor.judge(at + toggle * (i % 2))) << at << " " << i;
      }
      for (int i = 0; i < 1000; ++i) EXPECT_TRUE(monitor.judge(at)) << at;
      EXPECT_FALSE(monitor.judge(at == INT32_MAX ? at - 2 : at + 2));
    }
  }
  fog::StuckMonitor monitor({100, 1});
  for (int i = 0; i < 10000; ++i) EXPECT_FALSE(monitor.judge(i % 3)) << i;
}

// A converter of 2 counts rms behind a loop that stands, and a gyro with 4000 counts.
TEST(StuckMonitor, Whisper_WithinABandOfTheNoise_Stuck) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  fog::StuckMonitor monitor({100, 1000});
  const auto judge = [&](double rms, double mean) {
    return monitor.judge(static_cast<std::int32_t>(std::lround(mean + rms * noise(random))));
  };
  for (int i = 0; i < 1'000'000; ++i) EXPECT_FALSE(judge(4000, 0)) << i;
  for (int i = 0; i < 1'000'000; ++i) EXPECT_FALSE(judge(1000, 12345)) << "a quieter one " << i;
  int stuck = 0;
  for (int i = 0; i < 1000; ++i) stuck += judge(2, 70'000);
  EXPECT_EQ(stuck, 1000 - 99);
  EXPECT_FALSE(judge(4000, -200'000));
}

TEST(StuckMonitor, Band_OfAllCounts_DoesNotWrap) {
  fog::StuckMonitor monitor({3, INT32_MAX});
  for (const std::int32_t counts : {INT32_MIN, 0, INT32_MIN, 1})
    EXPECT_FALSE(monitor.judge(counts));
  EXPECT_FALSE(monitor.judge(INT32_MAX));
  EXPECT_TRUE(monitor.judge(0));
}

// Of a gyro that turns by 20,000 deg/s^2 at most.
fog::RateMonitor rate_monitor(Rate range, std::uint32_t period_us) {
  const double step_dph = 20'000.0 * 3600 * period_us * 1e-6;
  const double max_dph = std::ldexp(INT32_MAX, -fog::RateStep::fractional_bits);
  const auto raw = static_cast<std::int32_t>(
      std::ldexp(std::min(step_dph, max_dph), fog::RateStep::fractional_bits));
  return {{range, fog::RateStep::from_raw(raw)}, period_us};
}

TEST(RateMonitor, RangeIsSetAt97AndAHalfAndClearedBelow92AndAHalfFor50Milliseconds) {
  for (const double sign : {1.0, -1.0}) {
    fog::RateMonitor monitor = rate_monitor(deg_per_s(400), kPeriodUs);
    const auto flagged = [&](double rate) {
      return has_any(monitor.judge(deg_per_s(sign * rate), true, 1), Status::rate_out_of_range);
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

TEST(RateMonitor, LimitsOfTheRangeAreExactToTheLsb) {
  const auto flagged_at = [](fog::RateMonitor& monitor, std::int32_t raw) {
    return has_any(monitor.judge(Rate::from_raw(raw), true, 1), Status::rate_out_of_range);
  };
  for (const std::int32_t sign : {1, -1}) {
    // One sample per second: nothing is a jump, and one sample below the limit is enough.
    fog::RateMonitor slow = rate_monitor(Rate::from_raw(1'000'001), 1'000'000);
    EXPECT_FALSE(flagged_at(slow, sign * 974'999));
    EXPECT_TRUE(flagged_at(slow, sign * 975'000));
    EXPECT_TRUE(flagged_at(slow, sign * 925'001));
    EXPECT_FALSE(flagged_at(slow, sign * 925'000));
    EXPECT_FALSE(flagged_at(slow, sign * 950'000));
    // 50 ms of 4.9 ms are 11 samples, of 5 ms 10.
    for (const auto& [period_us, samples] : {std::pair{4900U, 11}, {5000U, 10}, {50'000U, 1}}) {
      fog::RateMonitor monitor = rate_monitor(Rate::from_raw(1'000'000), period_us);
      EXPECT_TRUE(flagged_at(monitor, sign * 975'000));
      for (int i = 1; i < samples; ++i) EXPECT_TRUE(flagged_at(monitor, 0)) << i;
      EXPECT_FALSE(flagged_at(monitor, 0)) << period_us;
    }
    fog::RateMonitor gap = rate_monitor(Rate::from_raw(1'000'000), 5000);
    EXPECT_TRUE(flagged_at(gap, sign * 975'000));
    EXPECT_TRUE(has_any(gap.judge(Rate{}, true, 9), Status::rate_out_of_range));
    EXPECT_FALSE(flagged_at(gap, 0)) << "lost samples are time as well";
  }
}

constexpr std::int32_t kStep = 73'728 * 100;  // LSB within 100 us

TEST(RateMonitor, AStepIsExactToTheLsb) {
  for (const std::int32_t sign : {1, -1}) {
    const auto judge = [&](fog::RateMonitor& monitor, std::int32_t raw, std::uint32_t elapsed = 1) {
      return monitor.judge(Rate::from_raw(sign * raw), true, elapsed);
    };
    fog::RateMonitor exact = rate_monitor(Rate::highest(), 100);
    EXPECT_EQ(judge(exact, 0), Status::none);
    EXPECT_EQ(judge(exact, kStep), Status::none);
    EXPECT_EQ(judge(exact, 2 * kStep + 1), Status::rate_jump);
    EXPECT_EQ(judge(exact, kStep), Status::none);
    EXPECT_EQ(judge(exact, 5 * kStep, 4), Status::none);
    EXPECT_EQ(judge(exact, 1), Status::rate_jump);

    // Within two steps of the last accepted sample, two samples ago, and within one of the
    // preceding one.
    fog::RateMonitor near = rate_monitor(Rate::highest(), 100);
    EXPECT_EQ(judge(near, 0), Status::none);
    EXPECT_EQ(judge(near, 3 * kStep), Status::rate_jump);
    EXPECT_EQ(judge(near, 2 * kStep), Status::none);
    fog::RateMonitor far = rate_monitor(Rate::highest(), 100);
    EXPECT_EQ(judge(far, 0), Status::none);
    EXPECT_EQ(judge(far, 3 * kStep + 1), Status::rate_jump);
    EXPECT_EQ(judge(far, 2 * kStep), Status::rate_jump);
    EXPECT_EQ(judge(far, 2 * kStep), Status::none);
  }
}

TEST(RateMonitor, OnlyValidRatesInRangeAreAccepted) {
  fog::RateMonitor invalid = rate_monitor(Rate::highest(), 100);
  EXPECT_EQ(invalid.judge(Rate{}, false, 1), Status::none);
  EXPECT_EQ(invalid.judge(Rate::from_raw(9 * kStep), true, 1), Status::none) << "the first";
  EXPECT_EQ(invalid.judge(Rate::from_raw(10 * kStep), false, 1), Status::none);
  EXPECT_EQ(invalid.judge(Rate::from_raw(9 * kStep), true, 1), Status::none);
  fog::RateMonitor beyond = rate_monitor(Rate::from_raw(100 * kStep), 100);
  EXPECT_EQ(beyond.judge(Rate::from_raw(99 * kStep), true, 1), Status::rate_out_of_range);
  EXPECT_FALSE(has_any(beyond.judge(Rate{}, true, 1), Status::rate_jump)) << "none accepted yet";
}

TEST(RateMonitor, ASpikeIsRefusedAndTheSampleAfterItAccepted) {
  fog::RateMonitor monitor = rate_monitor(deg_per_s(500), kPeriodUs);
  EXPECT_EQ(monitor.judge(deg_per_s(1), true, 1), Status::none);
  EXPECT_EQ(monitor.judge(deg_per_s(102), true, 1), Status::rate_jump);
  EXPECT_EQ(monitor.judge(deg_per_s(1), true, 1), Status::none);
  EXPECT_EQ(monitor.judge(deg_per_s(100), true, 1), Status::none);
}

TEST(RateMonitor, ANewSteadyRateIsAcceptedAsSoonAsItCanHaveBeenReached) {
  fog::RateMonitor monitor = rate_monitor(deg_per_s(500), kPeriodUs);
  EXPECT_EQ(monitor.judge(deg_per_s(0), true, 1), Status::none);
  for (int i = 1; i < 4; ++i) EXPECT_EQ(monitor.judge(deg_per_s(399), true, 1), Status::rate_jump);
  EXPECT_EQ(monitor.judge(deg_per_s(399), true, 1), Status::none);
  EXPECT_EQ(monitor.judge(deg_per_s(-200), true, 6), Status::none);  // five samples were lost
}

TEST(RateMonitor, Outage_OfAllNumbers_TimeDoesNotComeRound) {
  fog::RateMonitor monitor = rate_monitor(deg_per_s(500), kPeriodUs);
  EXPECT_EQ(monitor.judge(deg_per_s(0), true, 1), Status::none);
  for (int i = 0; i < 4; ++i) monitor.judge(deg_per_s(399), false, 1U << 30U);  // 2^32 samples
  EXPECT_EQ(monitor.judge(deg_per_s(399), true, 1), Status::none);
}

// From 120 deg/s on; it may change by 100 deg/s in a sample.
TEST(RateMonitor, SignFlips_FlaggedUntilItIsBack) {
  fog::RateMonitor monitor = rate_monitor(deg_per_s(500), kPeriodUs);
  const auto flagged = [&](double rate) {
    return has_any(monitor.judge(deg_per_s(rate), true, 1), Status::rate_jump);
  };
  EXPECT_FALSE(flagged(60));
  EXPECT_FALSE(flagged(120));
  for (int i = 0; i < 60 * kSecond; ++i) EXPECT_TRUE(flagged(-120 - i % 7)) << i;
  EXPECT_FALSE(flagged(119)) << "it is back";
  for (int i = 119; i < 300; ++i) EXPECT_FALSE(flagged(i));
  for (int i = 300; i > 50; --i) EXPECT_TRUE(flagged(-i)) << i;
  for (int i = 50; i > 0; --i) EXPECT_FALSE(flagged(-i)) << "it may have turned " << i;
}

TEST(RateMonitor, SpikeOfTheOtherSign_FlaggedAlone) {
  fog::RateMonitor monitor = rate_monitor(deg_per_s(500), kPeriodUs);
  for (int i = 60; i < 1000; ++i) {
    const double rate = std::min(i, 300);
    const bool spike = i % 10 == 0 && i > 100;
    const Status status = monitor.judge(deg_per_s(spike ? -rate : rate), true, 1);
    EXPECT_EQ(status, spike ? Status::rate_jump : Status::none) << i;
  }
}

TEST(RateMonitor, LostSamples_OtherSignBelieved) {
  fog::RateMonitor monitor = rate_monitor(deg_per_s(500), kPeriodUs);
  EXPECT_EQ(monitor.judge(deg_per_s(90), true, 1), Status::none);
  EXPECT_EQ(monitor.judge(deg_per_s(-90), true, 2), Status::none);
}

TEST(RateMonitor, ARateThatLeapsToAndFroIsNeverBelieved) {
  fog::RateMonitor monitor = rate_monitor(deg_per_s(500), kPeriodUs);
  EXPECT_EQ(monitor.judge(deg_per_s(0), true, 1), Status::none);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(monitor.judge(deg_per_s(i % 2 == 0 ? 300 : -300), true, 1), Status::rate_jump) << i;
  }
}

// Judges a rate that ramps from 0 to `peak` and back by `slope` deg/s per sample, as a gyro of
// +-200 deg/s outputs it. Returns how many valid samples were wrong by more than 1 deg/s, and how
// many at the end, at rest, were invalid.
struct FaceVerdict {
  int wrong = 0;
  int refused_at_rest = 0;
};
template <class Face>
FaceVerdict turn_beyond_the_range(Face face, double slope, fog::RateMonitor monitor) {
  FaceVerdict verdict;
  const auto judge = [&](double rate, int& refused) {
    const double shown = face(rate);
    const bool valid = monitor.judge(deg_per_s(shown), true, 1) == Status::none;
    verdict.wrong += valid && std::abs(shown - rate) > 1;
    refused += !valid;
  };
  int ignored = 0;
  for (double rate = 0; rate < 360; rate += slope) judge(rate, ignored);
  for (int i = 0; i < 2000; ++i) judge(360, ignored);
  for (double rate = 360; rate > 0; rate -= slope) judge(rate, ignored);
  for (int i = 0; i < 100; ++i) judge(0, verdict.refused_at_rest);
  return verdict;
}

fog::RateMonitor monitor_of_200() {
  const auto step = static_cast<std::int32_t>(10 * 3600 * 512);  // 10 deg/s: 2,000 deg/s^2
  return {{deg_per_s(200), fog::RateStep::from_raw(step)}, kPeriodUs};
}

TEST(RateMonitor, AGyroThatFoldsIsNotValidUntilItHasUnfolded) {
  const auto folds = [](double rate) { return rate > 200 ? rate - 400 : rate; };
  for (const double slope : {0.1, 1.0, 3.0, 9.0}) {
    const FaceVerdict verdict = turn_beyond_the_range(folds, slope, monitor_of_200());
    EXPECT_EQ(verdict.wrong, 0) << slope;
    EXPECT_EQ(verdict.refused_at_rest, 0) << slope;
  }
}

TEST(RateMonitor, AGyroThatClipsIsNotValidWhileItDoes) {
  int dither = 0;
  const auto clips = [&](double rate) { return std::min(rate, 200 + (dither++ % 7 - 3) / 1024.0); };
  const FaceVerdict verdict = turn_beyond_the_range(clips, 3, monitor_of_200());
  EXPECT_EQ(verdict.wrong, 0);
  EXPECT_EQ(verdict.refused_at_rest, 0);
}

TEST(RateMonitor, ARateThatTurnedAboutUnseenHasNotFolded) {
  fog::RateMonitor lost = monitor_of_200();
  EXPECT_EQ(lost.judge(deg_per_s(150), true, 1), Status::none);
  EXPECT_EQ(lost.judge(deg_per_s(-150), true, 40), Status::none);
  fog::RateMonitor invalid = monitor_of_200();
  EXPECT_EQ(invalid.judge(deg_per_s(150), true, 1), Status::none);
  for (int i = 0; i < 40; ++i) invalid.judge(deg_per_s(-150), false, 1);
  EXPECT_EQ(invalid.judge(deg_per_s(-150), true, 1), Status::none);
  fog::RateMonitor seen = monitor_of_200();
  EXPECT_EQ(seen.judge(deg_per_s(150), true, 1), Status::none);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(seen.judge(deg_per_s(-150), true, 1), Status::rate_jump);
  }
  EXPECT_EQ(seen.judge(deg_per_s(150), true, 1), Status::none);
}

TEST(RateMonitor, AFullScaleStepIsNoJumpWhereASampleLastsHalfASecond) {
  fog::RateMonitor monitor = rate_monitor(deg_per_s(500), 500'000);
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

TEST_F(TemperatureMonitorTest, LimitsAreExactToTheLsb) {
  constexpr double kLsb = 1.0 / 65536;
  for (const double sign : {1.0, -1.0}) {
    const auto judge = [](fog::TemperatureMonitor& monitor, double temperature, int samples = 1) {
      return monitor.judge(degc(temperature), true, static_cast<std::uint32_t>(samples));
    };
    fog::TemperatureMonitor possible(kPeriodUs);
    const double end = sign > 0 ? 130 : -70;
    EXPECT_EQ(judge(possible, end + sign * kLsb), Status::temperature_invalid);
    EXPECT_EQ(judge(possible, end), Status::none);
    EXPECT_TRUE(fog::is_possible(degc(end)));
    EXPECT_FALSE(fog::is_possible(degc(end + sign * kLsb)));

    fog::TemperatureMonitor at_once(kPeriodUs);
    EXPECT_EQ(judge(at_once, 20), Status::none);
    EXPECT_EQ(judge(at_once, 20 + sign * 2), Status::none);
    EXPECT_EQ(judge(at_once, 20 + sign * (4 + 1.0 / 100)), kJump);

    // 2 degC plus 1 degC per second, and within 2 degC of the preceding reading.
    fog::TemperatureMonitor steady(kPeriodUs);
    EXPECT_EQ(judge(steady, 20), Status::none);
    EXPECT_EQ(judge(steady, 20 + sign * 5), kJump);
    EXPECT_EQ(judge(steady, 20 + sign * (5 + kLsb), 3 * kSecond - 1), kJump);
    EXPECT_EQ(judge(steady, 20 + sign * 5), Status::none);
    fog::TemperatureMonitor before(kPeriodUs);
    EXPECT_EQ(judge(before, 20), Status::none);
    EXPECT_EQ(judge(before, 20 + sign * (5 + kLsb)), kJump);
    EXPECT_EQ(judge(before, 20 + sign * 3, 3 * kSecond), kJump);
    EXPECT_EQ(judge(before, 20 + sign * 5), Status::none);

    fog::TemperatureMonitor near(kPeriodUs);
    EXPECT_EQ(judge(near, 85 + sign), Status::none);
    EXPECT_EQ(judge(near, 85), Status::none);
    fog::TemperatureMonitor off(kPeriodUs);
    EXPECT_EQ(judge(off, 85 + sign * (1 + kLsb)), Status::none);
    EXPECT_EQ(judge(off, 85), kJump);
  }
}

// As on the board: half a second of readings that agree with their predecessors.
class TemperatureConfirmationTest : public testing::Test {
 protected:
  using Use = fog::ReadingUse;
  Use send(double temperature, int samples = 1) {
    for (int i = 0; i < samples; ++i) monitor_.judge(degc(temperature), true, 1);
    return monitor_.use();
  }
  fog::TemperatureMonitor monitor_{kPeriodUs, 500'000};
};

TEST_F(TemperatureConfirmationTest, FirstReadingsAreConfirmedByHalfASecondThatAgrees) {
  send(0, 99);
  EXPECT_EQ(send(20), Use::good_new_history);
  EXPECT_EQ(send(20, 99), Use::good);
  EXPECT_FALSE(monitor_.confirmed());
  EXPECT_EQ(send(22), Use::good);
  EXPECT_TRUE(monitor_.confirmed());
}

TEST_F(TemperatureConfirmationTest, NothingIsConfirmedByThePowerOnReadingOrByNone) {
  EXPECT_EQ(send(85, 1000), Use::none);
  EXPECT_FALSE(monitor_.confirmed());
  send(20, 50);
  for (int i = 0; i < 1000; ++i) monitor_.judge(degc(20), false, 1);
  EXPECT_FALSE(monitor_.confirmed());
  send(0.5);
  fog::TemperatureMonitor slow(10'000'000, 500'000);
  slow.judge(degc(1), true, 1);
  EXPECT_FALSE(slow.confirmed()) << "by itself";
  slow.judge(degc(1), true, 1);
  EXPECT_TRUE(slow.confirmed());
}

TEST_F(TemperatureConfirmationTest, WhatIsAcceptedAfterAJumpIsGoodAnew) {
  send(20, kSecond);
  EXPECT_EQ(send(30, 8 * kSecond - 1), Use::none);
  EXPECT_EQ(send(30), Use::good_new_history);
  EXPECT_EQ(send(30), Use::good);
  EXPECT_EQ(send(60), Use::none);
  EXPECT_EQ(send(30.5), Use::good) << "a spike leaves no trace";
}

// After lost samples the temperature may have changed; the readings used were right.
TEST_F(TemperatureConfirmationTest, WhatACoilCanHaveReachedIsGoodOnceItIsConfirmed) {
  send(20, kSecond);
  monitor_.judge(degc(23), true, 60 * kSecond);
  EXPECT_EQ(monitor_.use(), Use::none);
  EXPECT_EQ(send(23, 99), Use::none);
  EXPECT_EQ(send(23), Use::good);
}

TEST_F(TemperatureConfirmationTest, WhatMovesAgainAfterItWasFrozenIsGoodAnew) {
  double reading = 20;
  for (int i = 0; i < 60; ++i) send(reading += 1.0 / 16, kSecond);
  EXPECT_EQ(send(reading, 119 * kSecond), Use::good);
  EXPECT_EQ(send(reading, 2 * kSecond), Use::none);
  EXPECT_EQ(send(reading + 0.5), Use::good_new_history);
  EXPECT_EQ(send(reading + 0.5), Use::good);
}

// (a) of SPEC.md: noise is four more changes of eight resolutions than others.
TEST_F(TemperatureMonitorTest, NoiseIsChangesOfEightResolutionsFourMoreThanOthers) {
  constexpr double kResolution = 1.0 / 1024;
  const auto after = [&](int large, double size) {
    fog::TemperatureMonitor monitor(kPeriodUs);
    double reading = 20;
    monitor.judge(degc(reading), true, 1);
    monitor.judge(degc(reading += kResolution), true, 1);
    for (int i = 0; i < large; ++i) {
      reading += i % 2 == 0 ? size * kResolution : -size * kResolution;
      EXPECT_EQ(monitor.judge(degc(reading), true, 1), Status::none);
    }
    EXPECT_EQ(monitor.judge(degc(reading), true, 60 * kSecond - 1), Status::none);
    return monitor.judge(degc(reading), true, 1);
  };
  EXPECT_EQ(after(3, 8), Status::none);
  EXPECT_EQ(after(4, 8), kFrozen);
  EXPECT_EQ(after(100, 8), kFrozen);
  EXPECT_EQ(after(100, 7), Status::none);
}

TEST_F(TemperatureMonitorTest, LargeChangesAreCountedUpToEightAndTakenBackBySmallOnes) {
  constexpr double kResolution = 1.0 / 1024;
  for (const int small : {4, 5}) {
    fog::TemperatureMonitor monitor(kPeriodUs);
    double reading = 20;
    monitor.judge(degc(reading), true, 1);
    monitor.judge(degc(reading += kResolution), true, 1);
    for (int i = 0; i < 50; ++i) {
      monitor.judge(degc(reading += (i % 2 == 0 ? 8 : -8) * kResolution), true, 1);
    }
    for (int i = 0; i < small; ++i) {
      monitor.judge(degc(reading += (i % 2 == 0 ? 1 : -1) * kResolution), true, 1);
    }
    EXPECT_EQ(monitor.judge(degc(reading), true, 60 * kSecond),
              small == 4 ? kFrozen : Status::none);
  }
}

// (b): a quarter of a degree, and four resolutions, since the start of the minute before.
TEST_F(TemperatureMonitorTest, MovingIsAQuarterOfADegreeAndFourResolutions) {
  const auto after = [&](double step, int steps) {
    fog::TemperatureMonitor monitor(kPeriodUs);
    double reading = 20;
    EXPECT_EQ(monitor.judge(degc(reading), true, 1), Status::none);
    for (int i = 0; i < steps; ++i) {
      EXPECT_EQ(monitor.judge(degc(reading += step), true, kSecond), Status::none);
    }
    EXPECT_EQ(monitor.judge(degc(reading), true, 120 * kSecond - 1), Status::none);
    return monitor.judge(degc(reading), true, 1);
  };
  EXPECT_EQ(after(1.0 / 16, 4), kFrozen);
  EXPECT_EQ(after(-1.0 / 16, 4), kFrozen);
  EXPECT_EQ(after(1.0 / 16, 3), Status::none);
  EXPECT_EQ(after(1.0 / 32, 8), kFrozen);
  EXPECT_EQ(after(1.0 / 32, 7), Status::none);
  EXPECT_EQ(after(1.0 / 8, 3), Status::none);  // three resolutions
  EXPECT_EQ(after(1.0 / 8, 4), kFrozen);
}

TEST_F(TemperatureMonitorTest, WhatMovedLongerAgoThanTheMinuteBeforeDoesNotCount) {
  for (const int rest_s : {110, 118}) {
    fog::TemperatureMonitor monitor(kPeriodUs);
    double reading = 20;
    monitor.judge(degc(reading), true, 1);
    for (int i = 0; i < 4; ++i) monitor.judge(degc(reading += 1.0 / 16), true, kSecond);
    for (int i = 0; i < rest_s; ++i) {
      EXPECT_EQ(monitor.judge(degc(reading), true, kSecond), Status::none);
    }
    // Two more changes, which alone are not those of a moving coil.
    for (int i = 0; i < 2; ++i) monitor.judge(degc(reading += 1.0 / 16), true, 1);
    EXPECT_EQ(monitor.judge(degc(reading), true, 120 * kSecond),
              rest_s == 110 ? kFrozen : Status::none)
        << rest_s;
  }
}

// Minutes end with the 60th, 120th ... reading of a second each: the change of the first minute
// counts until the second has ended.
TEST_F(TemperatureMonitorTest, AMinuteIsSixtySeconds) {
  for (const int moves_again : {120, 121}) {
    fog::TemperatureMonitor monitor(1'000'000);
    double reading = 20;
    for (int second = 1; second <= moves_again; ++second) {
      if ((second > 1 && second <= 5) || second == moves_again) reading += 1.0 / 16;
      EXPECT_EQ(monitor.judge(degc(reading), true, 1), Status::none) << second;
    }
    EXPECT_EQ(monitor.judge(degc(reading), true, 120), moves_again == 120 ? kFrozen : Status::none);
  }
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

TEST(ExtensionMonitor, Silence_OfAllNumbers_TimeDoesNotComeRound) {
  using fog::Input;
  constexpr fog::InputMask kNeeded = fog::bit_of(Input::temperature2);
  const std::int32_t limits[] = {degc(-70).raw(), degc(130).raw(), degc(2).raw()};
  fog::ExtensionMonitor<kNeeded> monitor(kNeeded, {limits, 3}, kPeriodUs, 0);
  const auto judge = [&](double temperature) {
    return monitor.judge({Input::temperature2, degc(temperature)});
  };
  EXPECT_NE(judge(20), fog::ReadingUse::none);
  for (const std::uint32_t samples : {0x7FFFFFFFU, 0x7FFFFFFFU, 2U}) monitor.advance(samples);
  EXPECT_EQ(judge(90), fog::ReadingUse::none) << "nothing agrees with it yet";
  EXPECT_NE(judge(90), fog::ReadingUse::none) << "in 2^32 samples a sensor can get there";
}

TEST(ExtensionMonitor, ImageWithoutInputs_WaitsForNone) {
  fog::ExtensionMonitor<0> monitor(0, {}, kPeriodUs, 0);
  monitor.resume({});
  monitor.advance(1);
  EXPECT_TRUE(monitor.confirmed());
  EXPECT_EQ(monitor.judge({fog::Input::supply, degc(5)}), fog::ReadingUse::none);
}

// An input from the model table: only thermal mass makes these readings impossible.
class InputMonitorTest : public testing::TestWithParam<bool> {
 protected:
  fog::InputMonitor monitor_{kPeriodUs, 0, {degc(-100), degc(200), degc(2), GetParam()}};
};

TEST_P(InputMonitorTest, Reads85_RefusedIfThermalMass) {
  ASSERT_EQ(monitor_.judge(degc(20), true, 1), Status::none);
  monitor_.judge(degc(85), true, 1000 * kSecond);
  EXPECT_EQ(monitor_.judge(degc(85), true, 1), GetParam() ? kJump : Status::none);
}

TEST_P(InputMonitorTest, StopsAfterMoving_FrozenIfThermalMass) {
  double reading = 20;
  for (int i = 0; i < 300; ++i) {
    ASSERT_EQ(monitor_.judge(degc(reading += 1.0 / 16), true, kSecond), Status::none);
  }
  EXPECT_EQ(monitor_.judge(degc(reading), true, 121 * kSecond),
            GetParam() ? kFrozen : Status::none);
}

INSTANTIATE_TEST_SUITE_P(ThermalMass, InputMonitorTest, testing::Bool());

}  // namespace
