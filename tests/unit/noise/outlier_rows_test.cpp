#include "noise/outlier_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "unit/fit/made_rows.hpp"

namespace fogcomp::noise {
namespace {

constexpr std::size_t kRows = 6000;

std::vector<double> white_noise(std::uint64_t seed, std::size_t rows = kRows) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values(rows);
  for (double& value : values) value = normal(random);
  return values;
}

ValuesInTime whole(std::vector<double> values) {
  const std::size_t rows = values.size();
  return {std::move(values), {}, {{0, rows}}, {}};
}

std::vector<std::size_t> found(const ValuesInTime& rows) {
  const std::vector<bool> outlier = find_outliers(rows);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < outlier.size(); ++i) {
    if (outlier[i]) places.push_back(i);
  }
  return places;
}

// How many outliers 20 recordings of white noise plus `drift` (of the row) have.
std::size_t found_in_20(const std::function<double(double)>& drift) {
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::vector<double> values = white_noise(seed);
    for (std::size_t i = 0; i < kRows; ++i) values[i] += drift(static_cast<double>(i));
    count += found(whole(std::move(values))).size();
  }
  return count;
}

TEST(OutlierRows, OfWhiteNoiseThereIsLessThanOneInARecording) {
  EXPECT_LE(found_in_20([](double) { return 0; }), 10U);
  std::size_t short_ones = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    short_ones += found(whole(white_noise(seed, 60))).size();
  }
  EXPECT_LE(short_ones, 10U);
  EXPECT_LE(found(whole(white_noise(1, 1000000))).size(), 2U);
}

TEST(OutlierRows, RowsOfTenSigmaAreFound) {
  std::size_t hit = 0;
  std::size_t wrong = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::vector<double> values = white_noise(seed);
    for (std::size_t i = 500; i < kRows; i += 1000) values[i] += i % 2000 == 500 ? 10 : -10;
    for (const std::size_t row : found(whole(std::move(values)))) {
      ++(row % 1000 == 500 ? hit : wrong);
    }
  }
  EXPECT_GE(hit, 118U);  // of 120
  EXPECT_LE(wrong, 10U);
}

TEST(OutlierRows, UpToThreeRowsTogetherAreFoundAndTheirNeighboursStay) {
  for (const double size : {30.0, 1e6}) {
    std::vector<double> values = white_noise(5);
    for (const std::size_t row : {0U, 100U, 101U, 3000U, 3001U, 3002U, 5999U}) values[row] += size;
    EXPECT_EQ(found(whole(values)),
              (std::vector<std::size_t>{0, 100, 101, 3000, 3001, 3002, 5999}));
  }
}

// A missing effect is not an outlier, however far it exceeds the noise.
TEST(OutlierRows, DriftOfAnySizeIsNone) {
  for (const double size : {20.0, 1e3, 1e6}) {
    const std::vector<std::function<double(double)>> drifts{
        [](double row) { return row / 100; },                             // a line
        [](double row) { return row < 2000 || row > 2300 ? 0.0 : 1.0; },  // a ramp far off
        [](double row) { return row < 2000 ? 0.0 : 1.0; },                // a bias step
        [](double row) { return std::abs(row - 3000) / 10; },             // a corner
        [](double row) { return std::exp(-row / 2); },                    // a warm-up
        [](double row) { return row < 1000 ? 0.0 : std::exp((1000 - row) / 10); },
        [](double row) { return row < 2000 || row > 2400 ? 0.0 : std::sin(row / 2); },
    };
    for (std::size_t i = 0; i < drifts.size(); ++i) {
      EXPECT_LE(found_in_20([&](double row) { return size * drifts[i](row); }), 14U)
          << size << " " << i;
    }
  }
}

TEST(OutlierRows, OscillationsOfAnyPeriodAreNone) {
  constexpr double kTwoPi = 6.283185307179586;
  for (double period = 2; period < 400; period *= 1.013) {
    std::vector<double> values = white_noise(1, 1000);
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] += 1e4 * std::sin(kTwoPi * static_cast<double>(i) / period);
    }
    EXPECT_LE(found(whole(std::move(values))).size(), 3U) << period;
  }
}

TEST(OutlierRows, NoiseThatIsLargerInAPartIsNone) {
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::vector<double> values = white_noise(seed);
    for (std::size_t i = 3000; i < 3600; ++i) values[i] *= 5;
    count += found(whole(std::move(values))).size();
  }
  EXPECT_LE(count, 20U);
}

// Student's t with 5 degrees of freedom has 0.8 % of its rows beyond 4 of its robust sigmas.
TEST(OutlierRows, OfHeavyTailsFewRowsAreLeftOut) {
  std::mt19937_64 random(1);
  std::student_t_distribution<double> heavy(5);
  std::vector<double> values(kRows);
  for (double& value : values) value = heavy(random);
  const std::size_t count = found(whole(std::move(values))).size();
  EXPECT_GE(count, kRows / 1000);
  EXPECT_LE(count, kRows / 100);
}

TEST(OutlierRows, AShortTurnOfARateTableIsNone) {
  std::vector<double> values = white_noise(1);
  std::vector<double> input(kRows, 0.0);
  for (const std::size_t row : {1000U, 2000U, 2001U, 4000U}) {
    input[row] = 1e5;
    values[row] += 90;
  }
  ValuesInTime rows = whole(values);
  EXPECT_EQ(found(rows).size(), 4U);
  rows.inputs = {input};
  EXPECT_EQ(found(rows).size(), 0U);
  rows = whole(white_noise(2));
  rows.inputs = {input};
  // While the table oscillates, an outlier is compared with rows at its own rate.
  for (std::size_t i = 0; i < kRows; ++i) {
    rows.inputs[0][i] = i / 2 % 2 == 0 ? 1e5 : -1e5;
    rows.values[i] += i / 2 % 2 == 0 ? 90 : -90;
  }
  rows.values[3000] += 2000;
  EXPECT_EQ(found(rows), std::vector<std::size_t>{3000});
}

TEST(OutlierRows, ARowOfFewSamplesMayBeAsNoisyAsItIs) {
  std::vector<double> values = white_noise(1);
  values[3000] = 9;
  ValuesInTime rows = whole(std::move(values));
  EXPECT_EQ(found(rows).size(), 1U);
  rows.weights.assign(kRows, 1);
  rows.weights[3000] = 0.1;
  EXPECT_EQ(found(rows).size(), 0U);
}

TEST(OutlierRows, CoarseStepsOfTheRateAreNone) {
  std::vector<double> values = white_noise(1);
  for (double& value : values) value = std::round(value / 3);
  EXPECT_LE(found(whole(values)).size(), 2U);
  values[3000] = 100;
  const std::vector<std::size_t> places = found(whole(values));
  EXPECT_TRUE(std::find(places.begin(), places.end(), 3000U) != places.end());
  EXPECT_EQ(found(whole(std::vector<double>(kRows, 0.5))).size(), 0U);
}

TEST(OutlierRows, ABridgeIsAStraightLine) {
  std::vector<double> values{9, 1, 2, 9, 9, 5, 9};
  bridge_outliers({true, false, false, true, true, false, true}, {{0, 7}}, values);
  EXPECT_EQ(values, (std::vector<double>{1, 1, 2, 3, 4, 5, 5}));
}

TEST(OutlierRows, ABridgeLeadsNowhereFromOneRecordingToTheNext) {
  series::Rows rows = fog::test::made_rows(6, [](double) { return 20; });
  rows.run_starts = {0, 3};
  Eigen::VectorXd values(6), counted(6), bridge(6);
  values << 1, 2, 50, 50, 8, 9;
  counted << 1, 1, 0, 0, 1, 1;
  bridge << 1, 2, 2, 8, 8, 9;
  EXPECT_EQ(bridged(rows, values, counted), bridge);
}

}  // namespace
}  // namespace fogcomp::noise
