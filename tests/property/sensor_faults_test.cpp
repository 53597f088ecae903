// Detection of a broken sensor by the whole pipeline: each fault is injected into a healthy stream.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <random>

#include "board/host_compensator.hpp"
#include "support/overflow_guard.hpp"
#include "support/sample_models.hpp"

namespace {

using fog::OutputSample;
using fog::SensorSample;
using fog::Status;

constexpr int kSecond = 200;
constexpr double kCountsPerDegPerS = 3600 * 1024;

// A board with the sample model and a gyro at rest under its noise, warming by 1 degC/min behind a
// sensor of 1/16 degC.
class SensorFaults : public testing::Test {
 protected:
  SensorFaults() {
    parameters_ = fogcomp::board::read_board_table(table_, "test");
    board_ = std::make_unique<fogcomp::board::HostCompensator>(parameters_,
                                                               fog::IntegrityToken::not_needed());
  }

  SensorSample healthy() {
    const auto noise = static_cast<std::int32_t>(random_() % 4001U) - 2000;
    const double degc = std::floor((20 + time_ / 12000.0) * 16) / 16;
    ++time_;
    return {++sequence_, noise, static_cast<std::int32_t>(degc * 65536), true, true};
  }
  OutputSample send(const SensorSample& sample) { return last_ = board_->process(sample); }
  OutputSample run(int samples) {
    OutputSample last;
    for (int i = 0; i < samples; ++i) last = send(healthy());
    return last;
  }

  using Fault = std::function<void(SensorSample&)>;

  /// Samples with the fault until `flag` is set (that sample included), or `max` + 1.
  int samples_until(Status flag, int max, const Fault& fault) {
    for (int i = 1; i <= max; ++i) {
      SensorSample sample = healthy();
      fault(sample);
      if (has_any(send(sample).status, flag)) return i;
    }
    return max + 1;
  }

  fogcomp::board::BoardTable table_ =
      fogcomp::board::make_board_table(fog::test::paper_like_model(), fog::test::lenient_board());
  fog::ModelParameters parameters_;
  std::unique_ptr<fogcomp::board::HostCompensator> board_;
  OutputSample last_;
  std::mt19937 random_{1};
  std::uint16_t sequence_ = 60000;
  int time_ = 0;
};

TEST_F(SensorFaults, AStuckGyroIsInvalidWithinHalfASecond) {
  for (const unsigned values : {1U, 2U, 7U}) {  // the last: a converter with 2 counts rms
    run(10 * kSecond);
    const int samples = samples_until(Status::gyro_stuck, kSecond, [&](SensorSample& sample) {
      sample.rate_counts = 777 + static_cast<std::int32_t>(random_() % values);
    });
    std::printf("stuck gyro, %u values: not valid after %.3f s\n", values,
                (samples - 1) / double{kSecond});
    EXPECT_LE(samples - 1, kSecond / 2);
    EXPECT_FALSE(has_any(run(1).status, Status::gyro_stuck));
  }
}

// At 120 deg/s; the gyro turns on at 1 deg/s^2 meanwhile.
TEST_F(SensorFaults, SignFlips_InvalidUntilItIsBack) {
  run(kSecond);
  const auto turn = [&](double rate) {
    SensorSample sample = healthy();
    sample.rate_counts += static_cast<std::int32_t>(rate * kCountsPerDegPerS);
    return send(sample);
  };
  for (int i = 0; i < kSecond; ++i) EXPECT_TRUE(turn(120.0 * i / kSecond).compensated_valid());
  for (int i = 0; i < 60 * kSecond; ++i) {
    const OutputSample out = turn(-120 - i / double{kSecond});
    EXPECT_TRUE(has_any(out.status, Status::rate_jump)) << i;
    EXPECT_FALSE(out.compensated_valid());
  }
  EXPECT_TRUE(turn(180).compensated_valid());
}

TEST_F(SensorFaults, ARampBeyondTheRangeIsFlaggedAndNeverWrapsAround) {
  run(kSecond);
  double set_at = 0;
  for (const double sign : {1.0, -1.0}) {
    double clear_at = 0;
    for (double rate = 0; rate < 582.5; rate += 0.25) {  // beyond what 32 bits of counts hold
      SensorSample sample = healthy();
      const double counts = std::min(rate * kCountsPerDegPerS, 2147483647.0);
      sample.rate_counts = static_cast<std::int32_t>(sign * counts);
      const OutputSample out = send(sample);
      const bool flagged = has_any(out.status, Status::rate_out_of_range);
      ASSERT_EQ(flagged, rate >= 555.75) << rate;
      ASSERT_EQ(flagged, !out.compensated_valid()) << rate;
      ASSERT_NEAR(std::ldexp(out.compensated.raw(), -10) / 3600, sign * std::min(rate, 582.54),
                  0.01);
      if (flagged && set_at == 0) set_at = rate;
    }
    for (double rate = 580; rate > 0; rate -= 0.25) {
      SensorSample sample = healthy();
      sample.rate_counts = static_cast<std::int32_t>(sign * rate * kCountsPerDegPerS);
      if (!has_any(send(sample).status, Status::rate_out_of_range) && clear_at == 0)
        clear_at = rate;
    }
    std::printf("range +-570 deg/s: set at %.2f deg/s, cleared on the way back at %.2f\n",
                sign * set_at, sign * clear_at);
    EXPECT_NEAR(clear_at, 527.25 - 9 * 0.25, 0.3);  // below 92.5 % for 10 samples
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST_F(SensorFaults, SpikesAreFlaggedAndSpoilNoOtherSample) {
  run(10 * kSecond);
  const std::int32_t spikes[] = {INT32_MAX, INT32_MIN, 400000000, -400000000, 1900000000};
  double worst_dph = 0;
  for (const std::int32_t spike : spikes) {
    SensorSample sample = healthy();
    sample.rate_counts = spike;
    const OutputSample out = send(sample);
    EXPECT_TRUE(has_any(out.status, Status::rate_jump)) << spike;
    EXPECT_FALSE(out.compensated_valid());
    for (int i = 0; i < 5 * kSecond; ++i) {
      const OutputSample after = send(healthy());
      const bool range = has_any(after.status, Status::rate_out_of_range);
      EXPECT_TRUE(after.compensated_valid() || (range && i < 10)) << spike << " " << i;
      if (after.denoised_valid()) {
        worst_dph = std::max(worst_dph, std::abs(std::ldexp(after.denoised.raw(), -10)));
      }
    }
  }
  std::printf("5 spikes of 108 to 582 deg/s: all flagged; denoised rate never beyond %.2f deg/h\n",
              worst_dph);
  EXPECT_LT(worst_dph, 3);
}

// Temperature rate and ageing depend on time: after any disorder of the samples the board's block
// clock must agree with their true count.
TEST_F(SensorFaults, LostRepeatedLateAndReorderedSamplesAreFlaggedAndTimeStaysRight) {
  run(kSecond);
  const auto flagged = [&](std::uint32_t sequence) {
    SensorSample sample = healthy();
    sample.sequence = static_cast<std::uint16_t>(sequence);
    return has_any(send(sample).status, Status::sequence_gap);
  };
  int flags = 0;
  int disorders = 0;
  const std::uint32_t start = sequence_;
  std::uint32_t next = start;
  for (int i = 0; i < 20000; ++i) {
    ++next;
    switch (random_() % 40U) {
      case 0:
        next += static_cast<std::uint32_t>(random_() % 300U + 1U);  // lost
        ++disorders;
        flags += flagged(next);
        break;
      case 1:
        EXPECT_FALSE(flagged(next));
        ++disorders;
        flags += flagged(next);  // twice
        break;
      case 2:
        EXPECT_TRUE(flagged(next + 1U));  // exchanged with its successor
        ++disorders;
        flags += flagged(next);
        ++next;
        break;
      default:
        EXPECT_FALSE(flagged(next)) << i;
        break;
    }
  }
  std::printf("%d losses, repetitions and exchanges: %d flagged at their first sample\n", disorders,
              flags);
  EXPECT_EQ(flags, disorders);
  EXPECT_GT(disorders, 1000);

  // A block ends every 200 samples of the true count, and only there the drift may change.
  int changes = 0;
  for (int i = 0; i < 2000; ++i) {
    const fog::Rate before = last_.drift;
    const std::uint32_t samples_before = kSecond + next - start;
    SensorSample sample = healthy();
    sample.sequence = static_cast<std::uint16_t>(++next);
    sample.temperature_q16 += 300 * i;  // always on the move
    const bool changed = send(sample).drift != before;
    EXPECT_TRUE(!changed || samples_before % kSecond == 0) << i;
    changes += changed;
  }
  std::printf(
      "afterwards the drift changed %d times in 2000 samples, at ends of true seconds only\n",
      changes);
  EXPECT_GE(changes, 9);
}

TEST_F(SensorFaults, ABadTemperatureHoldsTheDriftThenGivesItUpThenRecovers) {
  struct Case {
    const char* name;
    Status flag;
    Fault fault;
  };
  std::int32_t stands = 0;
  const Case cases[] = {
      {"missing", Status::temperature_invalid,
       [](SensorSample& s) { s.temperature_valid = false; }},
      {"out of range", Status::temperature_invalid,
       [](SensorSample& s) { s.temperature_q16 = 131 * 65536; }},
      {"85 degC", Status::temperature_jump,
       [](SensorSample& s) { s.temperature_q16 = 85 * 65536; }},
      {"jump of 70 degC", Status::temperature_jump,
       [](SensorSample& s) { s.temperature_q16 += 70 * 65536; }},
      {"jump to and fro", Status::temperature_jump,
       [](SensorSample& s) {
         s.temperature_q16 = s.sequence % 2 == 0 ? -60 * 65536 : 110 * 65536;
       }},
      {"frozen", Status::temperature_frozen, [&](SensorSample& s) { s.temperature_q16 = stands; }},
  };
  for (const Case& c : cases) {
    stands = static_cast<std::int32_t>(healthy().temperature_q16);
    const OutputSample before = run(300 * kSecond);
    EXPECT_TRUE(before.compensated_valid()) << c.name;
    stands = before.temperature.raw();
    const int flagged = samples_until(c.flag, 130 * kSecond, c.fault);
    const int held = samples_until(Status::drift_held, 3 * kSecond, c.fault);
    const fog::Rate drift = last_.drift;
    const int given_up = samples_until(Status::drift_given_up, 63 * kSecond, c.fault);
    EXPECT_EQ(last_.drift, drift) << c.name;
    EXPECT_FALSE(last_.compensated_valid()) << c.name;
    const int recovered =
        samples_until(Status::thermal_settling, 5 * kSecond, [](SensorSample&) {});
    const OutputSample out = run(2);
    std::printf(
        "temperature %-16s flagged after %7.3f s, drift held %5.3f s later, given up %6.3f s "
        "later, valid again %5.3f s after the fault\n",
        c.name, (flagged - 1) / double{kSecond}, held / double{kSecond}, given_up / double{kSecond},
        recovered / double{kSecond});
    const bool is_frozen = c.flag == Status::temperature_frozen;
    EXPECT_LE(flagged, is_frozen ? 121 * kSecond : 1) << c.name;
    EXPECT_LE(held, 2 * kSecond) << c.name;
    EXPECT_NEAR(given_up, 60 * kSecond, 2) << c.name;
    EXPECT_LE(recovered, 3 * kSecond) << c.name;
    EXPECT_TRUE(out.compensated_valid()) << c.name;
  }
}

}  // namespace
