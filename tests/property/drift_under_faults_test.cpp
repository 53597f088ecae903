// The guarantee to a user of the rate: under any fault of the sensors, the line or the demodulator,
// a valid rate without flags has a drift within 0.05 deg/h of that of an uninterrupted run, apart
// from the effect of the temperature error itself.
#include "support/drift_under_faults.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "support/repeats.hpp"
#include "support/typical_effects.hpp"

namespace {

using fog::test::DriftUnderFaults;
using fog::test::DriftVerdict;
using fog::test::Fault;
using Kind = Fault::Kind;

constexpr double kDriftBoundDph = 0.05;
constexpr double kFirstFaultS = 700;  // of the first fault: the model has settled
constexpr double kRunS = 2000;
constexpr auto kSeeds = fog::test::repeats<std::uint64_t>(2, 1);

struct FaultCase {
  const char* name;
  std::vector<Fault> faults;
  double clean_within_s;  ///< after the last fault's end the rate is trusted again
};

void PrintTo(const FaultCase& c, std::ostream* out) {
  *out << c.name;
}

Fault at(Kind kind, double from_s, double lasts_s, double value = 0) {
  return {kind, kFirstFaultS + from_s, kFirstFaultS + from_s + lasts_s, value};
}

const std::vector<FaultCase>& fault_cases() {
  static const std::vector<FaultCase> all{
      {"temperature missing for 2 s", {at(Kind::no_temperature, 0, 2)}, 20},
      {"temperature missing for 55 s", {at(Kind::no_temperature, 0, 55)}, 220},
      {"temperature missing for 300 s", {at(Kind::no_temperature, 0, 300)}, 220},
      {"samples lost for 0.1 s", {at(Kind::no_samples, 0, 0.1)}, 1},
      {"samples lost for 10 s", {at(Kind::no_samples, 0, 10)}, 50},
      {"samples lost for 59 s", {at(Kind::no_samples, 0, 59)}, 220},
      {"every 3rd sample arrives", {at(Kind::sparse, 0, 300, 3)}, 1},
      {"every 500th sample arrives", {at(Kind::sparse, 0, 300, 500)}, 215},
      {"one bad first temperature", {{Kind::wrong_temperature, 0, 0.005, 0}}, 700},
      {"a bad first half second", {{Kind::wrong_temperature, 0, 0.4, 0}}, 700},
      {"a bad first 5 s", {{Kind::wrong_temperature, 0, 5, 0}}, 700},
      {"a cold first minute", {{Kind::wrong_temperature, 0, 60, -40}}, 700},
      {"a spike of temperature", {at(Kind::wrong_temperature, 0, 0.005, -60)}, 20},
      {"10 degC off for 20 s", {at(Kind::temperature_offset, 0, 20, 10)}, 300},
      {"10 degC off for 300 s", {at(Kind::temperature_offset, 0, 300, 10)}, 300},
      {"1.5 degC off for 20 s", {at(Kind::temperature_offset, 0, 20, 1.5)}, 20},
      {"85 degC for 20 s", {at(Kind::wrong_temperature, 0, 20, 85)}, 100},
      {"temperature frozen for 200 s", {at(Kind::frozen_temperature, 0, 200)}, 300},
      {"samples lost for 165 s", {at(Kind::no_samples, 0, 165)}, 220},
      {"samples lost for 200 s", {at(Kind::no_samples, 0, 200)}, 220},
      {"samples lost for 330 s", {at(Kind::no_samples, 0, 330)}, 220},
      {"samples lost for 655.36 s", {at(Kind::no_samples, 0, 655.36)}, 220},
      {"a demodulator that starts anew from 20000", {at(Kind::restart, 0, 0.05, 20000)}, 20},
      {"a demodulator that starts anew from 40000", {at(Kind::restart, 0, 0.05, 40000)}, 20},
      {"a demodulator that starts anew from 0", {at(Kind::restart, 0, 0.05, 0)}, 20},
      {"a demodulator that takes 40 s to start", {at(Kind::restart, 0, 40, 12345)}, 180},
      {"repeated samples", {at(Kind::repeated, 0, 60)}, 1},
      {"swapped samples", {at(Kind::swapped, 0, 60)}, 1},
      {"400 Hz from the start", {{Kind::sample_period, 0, kRunS, 2500}}, 0},
      {"400 Hz for 300 s", {at(Kind::sample_period, 0, 300, 2500)}, 250},
      {"100 Hz for 300 s", {at(Kind::sample_period, 0, 300, 10000)}, 250},
      {"206 Hz for 300 s", {at(Kind::sample_period, 0, 300, 4854)}, 250},
      {"gyro invalid for 60 s", {at(Kind::gyro_invalid, 0, 60)}, 1},
      {"the watchdog's restart", {at(Kind::board_restart, 0, 0.3)}, 20},
      {"a fault's restart in the middle of a block", {at(Kind::board_restart, 0.4, 0.06)}, 20},
      {"restarts one upon the other",
       {at(Kind::board_restart, 0, 0.2), at(Kind::board_restart, 0.21, 0.2),
        at(Kind::board_restart, 5, 0.2)},
       20},
      {"a restart while the temperature is missing",
       {at(Kind::board_restart, 20, 0.3), at(Kind::no_temperature, 0, 40)},
       180},
      {"a restart with the demodulator's",
       {at(Kind::board_restart, 0, 0.3), at(Kind::restart, 0, 0.3, 31000)},
       220},
      {"a restart with the demodulator's, 10 s ahead",
       {at(Kind::board_restart, 0, 0.3), at(Kind::restart_ahead, 0, 0.3, 2000)},
       280},
      {"a restart with the demodulator's, 25 s ahead",
       {at(Kind::board_restart, 0, 0.3), at(Kind::restart_ahead, 0, 0.3, 5000)},
       280},
      {"one sample 500 times", {at(Kind::repeats_one, 0, 2.5)}, 20},
      {"numbers that leap by 25 a second", {at(Kind::leaps, 0, 60, 25)}, 280},
      {"a restart after 200 s without samples",
       {at(Kind::no_samples, 0, 200), at(Kind::board_restart, 199, 0.3)},
       220},
      {"reset by the pin", {at(Kind::pin_reset, 0, 0.3)}, 220},
      {"reset by the pin, held for 58 s", {at(Kind::pin_reset, 0, 58)}, 220},
      {"reset by the pin, held for 350 s", {at(Kind::pin_reset, 0, 350)}, 220},
  };
  return all;
}

DriftVerdict print(const char* name, const DriftVerdict& verdict) {
  std::printf("%-44s %5.1f %% trusted, off by %.3f deg/h at %7.1f s, trusted again from %.1f s\n",
              name,
              100.0 * static_cast<double>(verdict.trusted) / static_cast<double>(verdict.samples),
              verdict.worst_dph, verdict.worst_at_s, verdict.clean_since_s);
  return verdict;
}

void expect_right(const FaultCase& c, bool has_clock) {
  const DriftUnderFaults board(fog::test::paper_like_model(), 3, {has_clock});
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const DriftVerdict verdict = print(c.name, board.run(c.faults, kRunS, seed));
    EXPECT_LE(verdict.worst_dph, kDriftBoundDph) << "seed " << seed;
    EXPECT_LE(verdict.clean_since_s, c.faults.back().to_s + c.clean_within_s) << "seed " << seed;
  }
}

class DriftUnderAFault : public testing::TestWithParam<FaultCase> {};

TEST_P(DriftUnderAFault, IsRightWhereverTheRateIsTrusted) {
  expect_right(GetParam(), true);
}

// Nothing but the numbers of the samples says how much time has passed: what they say of losses
// may be a leap.
const std::vector<FaultCase>& fault_cases_without_a_clock() {
  static const std::vector<FaultCase> all{
      {"samples lost for 0.1 s", {at(Kind::no_samples, 0, 0.1)}, 1},
      {"samples lost for 10 s", {at(Kind::no_samples, 0, 10)}, 280},
      {"repeated samples", {at(Kind::repeated, 0, 60)}, 1},
      {"one sample 500 times", {at(Kind::repeats_one, 0, 2.5)}, 280},
      {"numbers that leap by 25 a second", {at(Kind::leaps, 0, 300, 25)}, 280},
      {"a demodulator that starts 10 s ahead", {at(Kind::restart_ahead, 0, 0.05, 2000)}, 280},
      {"a demodulator that starts 25 s ahead", {at(Kind::restart_ahead, 0, 0.05, 5000)}, 280},
      {"a demodulator that starts 150 s ahead", {at(Kind::restart_ahead, 0, 0.05, 30'000)}, 280},
      {"a demodulator that starts 10 s behind", {at(Kind::restart_ahead, 0, 0.05, 63'536)}, 280},
      // Schedule 7 of random_faults: 20,000 behind, after 23 s of silence.
      {"a demodulator that starts behind after 23 s",
       {at(Kind::restart_ahead, 0, 23, 45'000)},
       300},
      {"the watchdog's restart", {at(Kind::board_restart, 0, 0.3)}, 20},
  };
  return all;
}

class DriftWithoutAClock : public testing::TestWithParam<FaultCase> {};

TEST_P(DriftWithoutAClock, IsRightWhereverTheRateIsTrusted) {
  expect_right(GetParam(), false);
}

// KVH frames have no flags. The first two were found by random_faults: the first rate
// after a silence had the drift before it.
class DriftOfAValidRate : public testing::TestWithParam<FaultCase> {};

TEST_P(DriftOfAValidRate, IsRightWhereverTheKvhFrameIsValid) {
  const FaultCase& c = GetParam();
  fogcomp::model::Model model = fog::test::paper_like_model();
  model.rate_range_degc_per_min = fogcomp::model::Range{-3, 3};
  fog::test::TestedBoard setting;
  setting.has_reset_clock = setting.judged_by_validity = true;
  const DriftUnderFaults board(model, 3, setting);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const DriftVerdict verdict = print(c.name, board.run(c.faults, kRunS, seed));
    EXPECT_LE(verdict.worst_dph, kDriftBoundDph) << "seed " << seed;
    EXPECT_GT(verdict.trusted, verdict.samples / 2) << "or the test says little, seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Every, DriftOfAValidRate,
    testing::Values(
        FaultCase{"samples lost for 250 s", {at(Kind::no_samples, 0, 250)}, 0},
        FaultCase{"reset by the pin, held for 538 s", {at(Kind::pin_reset, 0, 538)}, 0},
        FaultCase{"temperature missing for 55 s", {at(Kind::no_temperature, 0, 55)}, 0},
        FaultCase{
            "a bit flipped in every sample for 300 s", {at(Kind::bits_flipped, 0, 300, 1)}, 0},
        // Schedule 4068 of random_faults: the bridge over a block without a sample never ended,
        // because each block had one sample, and a sample makes one step.
        FaultCase{"every 207th sample arrives", {at(Kind::sparse, 0, 300, 207)}, 0},
        FaultCase{"a byte lost in one sample of 3", {at(Kind::bytes_lost, 0, 300, 3)}, 0}));

fogcomp::model::Model model_with(const std::vector<fogcomp::model::EffectTerm>& terms) {
  fogcomp::model::Model model = fog::test::paper_like_model();
  model.network = {};
  model.terms.insert(model.terms.end(), terms.begin(), terms.end());
  return model;
}

// A board that starts in the middle of a ramp assumes that its lags have settled.
TEST(DriftAfterAStart, IsRightOnceTheSlowestLagHasSettled) {
  const DriftUnderFaults board(model_with({fog::test::natural_term("thermal_lag", {300}, {0.3}),
                                           fog::test::written_term("late = lag(T,200)-T")}));
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Fault off{Kind::power_cycle, 3000, 3001};
    const DriftVerdict verdict = print("off for a second, slow lags", board.run({off}, 6000, seed));
    EXPECT_LE(verdict.worst_dph, kDriftBoundDph) << "seed " << seed;
    EXPECT_NEAR(verdict.clean_since_s, off.to_s + 7 * 30 + 5 * 300, 5) << "seed " << seed;
  }
}

// ... and that its play operators are centred, in the middle of a loop.
TEST(DriftAfterAStart, IsRightOnceTheHistoryIsKnown) {
  const DriftUnderFaults board(
      model_with({fog::test::natural_term("thermal_hysteresis", {3, 10}, {0.3, 0.2}),
                  fog::test::written_term("loop = play(T,5)")}),
      1);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Fault off{Kind::power_cycle, 9000, 9001};
    const DriftVerdict verdict = print("off for a second, loops", board.run({off}, 15'000, seed));
    EXPECT_LE(verdict.worst_dph, kDriftBoundDph) << "seed " << seed;
    EXPECT_GT(verdict.clean_since_s, off.to_s + 7 * 30) << "seed " << seed;
    EXPECT_LT(verdict.clean_since_s, 15'000) << "seed " << seed;
  }
}

// State that would take minutes to recover is kept over the board's own restarts.
TEST(DriftAfterARestart, IsThatOfABoardThatNeverStopped) {
  const DriftUnderFaults board(
      model_with({fog::test::natural_term("thermal_lag", {300}, {0.3}),
                  fog::test::natural_term("thermal_hysteresis", {3, 10}, {0.3, 0.2}),
                  fog::test::natural_term("warm_up", {3000}, {0.5}),
                  fog::test::written_term("late = lag(T,200)-play(T,5)")}),
      1);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    std::vector<Fault> restarts;
    // A warm-up is not trusted for five time constants after power-on.
    for (double at_s = 16'000; at_s < 19'000; at_s += 237.3) {
      restarts.push_back({Kind::board_restart, at_s, at_s + 0.25});
    }
    const DriftVerdict verdict =
        print("restarts every 4 minutes", board.run(restarts, 19'200, seed));
    EXPECT_GT(verdict.trusted, verdict.samples / 10) << "or the test says nothing, seed " << seed;
    EXPECT_LE(verdict.worst_dph, kDriftBoundDph) << "seed " << seed;
    EXPECT_LE(verdict.clean_since_s, restarts.back().to_s + 20) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Every, DriftUnderAFault, testing::ValuesIn(fault_cases()));
INSTANTIATE_TEST_SUITE_P(Every, DriftWithoutAClock,
                         testing::ValuesIn(fault_cases_without_a_clock()));

}  // namespace
