// A rate table steps; the record tells its flanks, late or not, or it is of another movement.
#include "recording/reading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace fogcomp::recording::flanks {
namespace {

constexpr double kHoldS = 40;
constexpr int kHolds = 40;
constexpr double kFineS = 0.01;
constexpr double kPeriodS = 0.1;
constexpr int kFinePerSample = 10;

using Rates = std::vector<double>;  // deg/h, every 0.01 s

// What is asked of the table: every 40 s another rate up to 100 deg/s.
double asked_dph(double time_s) {
  const int hold = static_cast<int>(std::floor(time_s / kHoldS));
  return hold < 0 ? 0 : 360'000 * std::sin(2.4 * hold + 1);
}
// The table follows at 100 deg/s^2.
Rates movement() {
  Rates moved;
  double rate = asked_dph(0);
  for (int i = 0; i < static_cast<int>(kHolds * kHoldS / kFineS); ++i) {
    const double step = asked_dph(i * kFineS) - rate;
    rate += std::clamp(step, -360'000 * kFineS, 360'000 * kFineS);
    moved.push_back(rate);
  }
  return moved;
}
Rates asked() {
  Rates rates = movement();
  for (std::size_t i = 0; i < rates.size(); ++i)
    rates[i] = asked_dph(kFineS * static_cast<double>(i));
  return rates;
}
Rates late_by(double delay_s, const Rates& rates) {
  const auto rows = static_cast<std::size_t>(std::lround(delay_s / kFineS));
  Rates late = rates;
  for (std::size_t i = rows; i < rates.size(); ++i) late[i] = rates[i - rows];
  return late;
}
Rates means_of(const Rates& rates) {
  Rates means;
  for (std::size_t i = 0; i + kFinePerSample <= rates.size(); i += kFinePerSample) {
    double sum = 0;
    for (std::size_t k = 0; k < kFinePerSample; ++k) sum += rates[i + k];
    means.push_back(sum / kFinePerSample);
  }
  return means;
}

// A gyro with 1000 ppm beside this record.
Recording recording_of(const Rates& moved, const Rates& record, double noise_dph = 5) {
  Recording recording;
  recording.period_s = kPeriodS;
  recording.stretch_starts = {0};
  recording.input_rate_dph = means_of(record);
  recording.rate_dph = means_of(moved);
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, noise_dph);
  for (std::size_t i = 0; i < recording.rate_dph.size(); ++i) {
    recording.time_s.push_back(kPeriodS * static_cast<double>(i));
    recording.temperature_degc.push_back(20);
    recording.rate_dph[i] += 0.001 * recording.rate_dph[i] + noise(random);
  }
  return recording;
}

// More than the noise is left nowhere, and no more than the flanks is masked.
void expect_only_flanks_masked(const Recording& recording, const UnknownFlanks& unknown) {
  EXPECT_EQ(unknown.masks.size(), static_cast<std::size_t>(kHolds - 1));
  const std::vector<bool> masked = covered(unknown.masks, recording.time_s);
  double left_dph = 0;
  for (std::size_t i = 0; i < masked.size(); ++i) {
    if (masked[i]) continue;
    const double off = recording.rate_dph[i] - 1.001 * recording.input_rate_dph[i];
    left_dph = std::max(left_dph, std::abs(off));
  }
  EXPECT_LT(left_dph, 6 * 5);
  EXPECT_LT(length_s(unknown.masks), 0.15 * kHolds * kHoldS);
}

TEST(TableFlanks, AreKnownFromARecordOfTheMovement) {
  const UnknownFlanks unknown = unknown_flanks(recording_of(movement(), movement()));
  EXPECT_TRUE(unknown.masks.empty());
  EXPECT_FALSE(unknown.delay_s);
}

TEST(TableFlanks, TellByWhatTheRecordIsLate) {
  for (const double delay_s : {0.02, 0.12, 0.5}) {
    const Recording recording = recording_of(movement(), late_by(delay_s, movement()));
    const UnknownFlanks unknown = unknown_flanks(recording);
    ASSERT_TRUE(unknown.delay_s) << delay_s;
    EXPECT_NEAR(*unknown.delay_s, 1.001 * delay_s, 1e-4);  // the gyro has 1000 ppm
    expect_only_flanks_masked(recording, unknown);
  }
}

TEST(TableFlanks, TellByWhatTheGyroIsLate) {
  const UnknownFlanks unknown = unknown_flanks(recording_of(late_by(0.1, movement()), movement()));
  ASSERT_TRUE(unknown.delay_s);
  EXPECT_NEAR(*unknown.delay_s, -0.1, 1e-4);
}

TEST(TableFlanks, StayIfALateRecordIsMostlyFlanks) {
  Rates moved(movement().size());
  for (std::size_t i = 0; i < moved.size(); ++i) {
    moved[i] = 1000 * std::sin(2.4 * static_cast<double>(i / 300) + 1);  // 1.7 s of 3 are masked
  }
  const UnknownFlanks unknown = unknown_flanks(recording_of(moved, late_by(0.5, moved)));
  ASSERT_TRUE(unknown.delay_s);
  EXPECT_NEAR(*unknown.delay_s, 0.5, 1e-2);
  EXPECT_TRUE(unknown.masks.empty());
}

TEST(TableFlanks, AreUnknownFromACommandedRate) {
  const Recording recording = recording_of(movement(), asked());
  const UnknownFlanks unknown = unknown_flanks(recording);
  EXPECT_FALSE(unknown.delay_s);
  expect_only_flanks_masked(recording, unknown);
}

TEST(TableFlanks, AreUnknownFromValuesInSomeRhythm) {
  const Rates moved = movement();
  Rates held = moved;
  for (std::size_t i = 0; i < held.size(); ++i) held[i] = moved[i / 137 * 137];
  EXPECT_GT(unknown_flanks(recording_of(moved, held)).masks.size(), 30U);
}

TEST(TableFlanks, DoNotMatterBelowTheNoise) {
  EXPECT_TRUE(unknown_flanks(recording_of(movement(), asked(), 2e6)).masks.empty());
}

// A sweep never stands still.
TEST(TableFlanks, AreNoneWhereTheTableSweeps) {
  Rates sweep = movement();
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    sweep[i] = 360'000 * std::sin(0.2 * kFineS * static_cast<double>(i));
  }
  EXPECT_TRUE(unknown_flanks(recording_of(sweep, late_by(0.2, sweep))).masks.empty());
}

}  // namespace
}  // namespace fogcomp::recording::flanks
