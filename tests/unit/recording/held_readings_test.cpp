#include "recording/reading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "recording/recording.hpp"
#include "support/text.hpp"
#include "unit/recording/heard_in.hpp"
#include "unit/recording/temporary_file.hpp"

namespace fogcomp::recording {
namespace {

// White noise that the gyro delivers at `rate_hz`, in steps of `step`, as it is read at `polls_hz`.
std::vector<double> polled(double rate_hz, double polls_hz, double step = 1e-6) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0, 1);
  std::vector<double> rows;
  double reading = 0;
  double next_s = 0;
  for (int i = 0; i < 20000; ++i) {
    for (; i / polls_hz >= next_s; next_s += 1 / rate_hz) {
      reading = step * std::round(noise(random) / step);
    }
    rows.push_back(reading);
  }
  return rows;
}

TEST(HeldRate, PolledFasterThanDelivered_RepeatsFound) {
  for (const double ratio : {1.3, 1.5, 2.0, 3.2, 10.0, 17.7}) {
    // the second so coarse that neighbours are often equal
    for (const double step : {1e-6, ratio < 2 ? 1e-6 : 0.5}) {
      const std::vector<double> rows = polled(100, 100 * ratio, step);
      const std::vector<std::size_t> repeats = repeated_readings(rows);
      const double left = static_cast<double>(rows.size() - repeats.size());
      EXPECT_NEAR(static_cast<double>(rows.size()) / left, ratio, 0.02 * ratio)
          << ratio << ' ' << step;
      for (const std::size_t row : repeats) {
        ASSERT_EQ(rows[row], rows[row - 1]) << ratio << ' ' << step << " at " << row;
      }
    }
  }
}

TEST(HeldRate, EqualByChance_NoRepeats) {
  for (const double step : {1e-6, 0.05, 0.2, 0.5, 1.0, 2.0, 4.0}) {
    EXPECT_TRUE(repeated_readings(polled(100, 100, step)).empty()) << step;
  }
  EXPECT_TRUE(repeated_readings(std::vector<double>(20000, 3.5)).empty());
  EXPECT_TRUE(repeated_readings({}).empty());
}

TEST(HeldRate, FileOfRepeats_ReadAtTheRateOfTheGyro) {
  std::string said;
  std::string text = "time_s,temperature_degc,rate_dph\n";
  const std::vector<double> rows = polled(10, 32);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += format("%.5f,%.4f,%.6f\n", static_cast<double>(i) / 32,
                   20 + 1e-4 * static_cast<double>(i), rows[i]);
  }
  const Recording recording = read_recording(temporary_file("held.csv", text), heard_in(said));
  EXPECT_NEAR(recording.period_s, 0.1, 1e-4);
  EXPECT_EQ(recording.stretch_starts.size(), 1U);
  EXPECT_NE(
      said.find("held.csv: rate_dph repeats each reading until the next one: 6250 readings in "
                "20000 samples; repeats are left out"),
      std::string::npos)
      << said;
  ReadOptions every_row;
  every_row.every_row = true;
  EXPECT_EQ(read_recording(temporary_file("held.csv", text), every_row).rows(), rows.size());
}

}  // namespace
}  // namespace fogcomp::recording
