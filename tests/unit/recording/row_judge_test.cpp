#include "recording/reading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/acquisition/sample_monitor.hpp"
#include "heard_in.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "temporary_file.hpp"

namespace fogcomp::recording {
namespace {

using Rows = std::vector<std::size_t>;

// Two hours of a ramp up and down, 20 to 50 degC at 0.5 degC/min, behind 1/64 degC.
Recording ramps(double period_s) {
  Recording recording;
  recording.file = "run.csv";
  recording.period_s = period_s;
  for (double time_s = 0; time_s < 7200; time_s += period_s) {
    const double degc = 50 - std::fabs(time_s - 3600) / 120;
    recording.time_s.push_back(time_s);
    recording.temperature_degc.push_back(std::round(degc * 64) / 64);
    recording.rate_dph.push_back(0.7 + 0.01 * std::sin(time_s));
  }
  recording.stretch_starts = {0};
  return recording;
}

Recording with_temperature(double period_s, std::size_t rows,
                           const std::function<double(double)>& degc) {
  Recording recording;
  recording.file = "run.csv";
  recording.period_s = period_s;
  for (std::size_t row = 0; row < rows; ++row) {
    const double time_s = static_cast<double>(row) * period_s;
    recording.time_s.push_back(time_s);
    recording.temperature_degc.push_back(degc(time_s));
    recording.rate_dph.push_back(0.7);
  }
  recording.stretch_starts = {0};
  return recording;
}

Rows refused(const Recording& recording) {
  Rows rows;
  for (const RefusedRow& each : refused_rows(recording, {})) rows.push_back(each.row);
  return rows;
}

class RowsOf : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Seconds, RowsOf, ::testing::Values(0.005, 0.5, 1, 10, 60));

TEST_P(RowsOf, AHealthyRecordingLosesNone) {
  EXPECT_EQ(refused(ramps(GetParam())), Rows{});
}

// 85 degC: a DS18B20 before its first conversion, alone, in a burst, at the start and at the end.
TEST_P(RowsOf, APowerOnReadingIsRefusedAndNothingElse) {
  Recording recording = ramps(GetParam());
  const std::size_t last = recording.rows() - 1;
  Rows wrong{0, 1, 30, 50, 51, 52, 53, 54, 55, 80, last};
  for (const std::size_t row : wrong) recording.temperature_degc[row] = 85;
  const std::vector<RefusedRow> rows = refused_rows(recording, {});
  EXPECT_EQ(refused(recording), wrong);
  for (const RefusedRow& each : rows) EXPECT_EQ(each.why, Refusal::power_on_temperature);
}

TEST_P(RowsOf, AnImpossibleTemperatureIsRefusedAndNothingElse) {
  Recording recording = ramps(GetParam());
  const Rows wrong{0, 30, 50, 51};
  for (const std::size_t row : wrong) {
    recording.temperature_degc[row] = row % 20 == 0 ? -127 : 130.1;
  }
  EXPECT_EQ(refused(recording), wrong);
  EXPECT_EQ(refused_rows(recording, {})[0].why, Refusal::impossible_temperature);
}

TEST_P(RowsOf, AConstantTemperatureOf85DegreesIsASoak) {
  const auto soak = [](double) { return 85.0; };
  EXPECT_EQ(refused(with_temperature(GetParam(), 100, soak)), Rows{});
  EXPECT_EQ(refused(with_temperature(GetParam(), 1, soak)), Rows{});
}

// A programme's set points, without a coil's lag: exactly 85 degC at once.
TEST_P(RowsOf, ARampMayEndAndBeginAtExactly85Degrees) {
  for (const double degc_per_min : {3.0, 12.0}) {
    const auto to_85 = [&](double time_s) {
      return std::min(85.0, 25 + degc_per_min * time_s / 60);
    };
    const auto from_85 = [&](double time_s) {
      return std::max(-40.0, 85 - degc_per_min * std::max(0.0, time_s - 600) / 60);
    };
    const auto rows = static_cast<std::size_t>(3600 / GetParam());
    EXPECT_EQ(refused(with_temperature(GetParam(), rows, to_85)), Rows{});
    EXPECT_EQ(refused(with_temperature(GetParam(), rows, from_85)), Rows{});
  }
}

// As fast as a coil can: 1 degC/s, behind a sensor with steps of 1 degC.
TEST_P(RowsOf, TheFastestRampLosesNoneAndACoarseSensorNeither) {
  const auto fast = [](double time_s) { return std::round(-60 + std::min(time_s, 140.0)); };
  const auto rows = static_cast<std::size_t>(std::max(300 / GetParam(), 5.0));
  EXPECT_EQ(refused(with_temperature(GetParam(), rows, fast)), Rows{});
  const auto usual = [](double time_s) { return std::round(-40 + time_s * 3 / 60); };
  EXPECT_EQ(refused(with_temperature(GetParam(), rows, usual)), Rows{});
}

TEST_P(RowsOf, AfterALongGapAnyTemperatureIsRight) {
  Recording recording = ramps(GetParam());
  for (std::size_t row = 60; row < recording.rows(); ++row) {
    recording.time_s[row] += 3600;
    recording.temperature_degc[row] = row < 90 ? 85 : -55;
    if (row >= 90) recording.time_s[row] += 3600;
  }
  EXPECT_EQ(refused(recording), Rows{});
}

TEST(RowJudge, AFirstReadingThatTheOthersDenyIsRefusedNotTheOthers) {
  for (const double period_s : {0.005, 1.0, 10.0}) {
    Recording recording = ramps(period_s);
    recording.temperature_degc[0] = -10;
    EXPECT_EQ(refused(recording), Rows{0}) << period_s;
    recording.temperature_degc[1] = 110;
    EXPECT_EQ(refused(recording), (Rows{0, 1})) << period_s;
  }
}

// The board would accept -10 degC after 30 s, and refuse the good rows that follow.
TEST(RowJudge, AnExcursionIsRefusedFromItsBeginningAndNotWhatFollows) {
  for (const double period_s : {1.0, 10.0}) {
    Recording recording = ramps(period_s);
    Rows wrong;
    const auto rows = static_cast<std::size_t>(60 / period_s);
    for (std::size_t row = 100; row < 100 + rows; ++row) {
      wrong.push_back(row);
      recording.temperature_degc[row] = -10;
    }
    EXPECT_EQ(refused(recording), wrong) << period_s;
  }
}

// It says one value before it measures: 0 degC however long, another one for minutes.
TEST(RowJudge, SensorThatBeginsLate_RefusedUntilThen) {
  for (const double said_degc : {0.0, -40.0, 60.0, -50.0, 125.0}) {
    for (const int wrong : {1, 5, 18, 20, 60, 90, 300, 900}) {
      if (said_degc != 0 && wrong > 300) continue;
      const Rows rows = refused(with_temperature(1, 3000, [&](double time_s) {
        return time_s < wrong ? said_degc : 18 + std::round(time_s / 8) / 16;
      }));
      ASSERT_EQ(rows.size(), static_cast<std::size_t>(wrong)) << said_degc;
      EXPECT_EQ(rows.back(), static_cast<std::size_t>(wrong - 1));
    }
  }
}

// Soaks that were joined without a gap.
TEST(RowJudge, ANewLevelIsBelievedAsTheBoardBelievesIt) {
  const auto steps = [](double time_s) {
    return time_s < 300 ? 20 + time_s / 1000 : time_s < 700 ? 60.0 : 0.0;
  };
  EXPECT_EQ(refused(with_temperature(10, 200, steps)), (Rows{30, 31, 32, 70, 71, 72, 73, 74}));
  const auto joined = [](double time_s) { return time_s < 3000 || time_s >= 6000 ? 20.0 : 60.0; };
  const Rows rows = refused(with_temperature(10, 900, joined));
  EXPECT_EQ(rows, (Rows{300, 301, 302, 600, 601, 602})) << "until 1 degC/s would do";
}

// One rule: at the board's own sample rate, what the core's monitors refuse.
TEST(RowJudge, RefusesAt200HzWhatTheBoardRefuses) {
  std::mt19937 random(1);
  Recording recording = ramps(0.005);
  recording.time_s.resize(200000);
  recording.temperature_degc.resize(200000);
  recording.rate_dph.resize(200000);
  for (int fault = 0; fault < 2000; ++fault) {
    const std::size_t at = 10 + random() % 199900;
    const double degc[] = {85, 20 + static_cast<double>(random() % 20), -80, 140, -60};
    const double dph[] = {1e6, -2e6, 2.02e6, 4e5, 3e5};
    const auto kind = static_cast<unsigned>(random() % 10U);
    for (std::size_t row = at; row < at + 1 + random() % 30; ++row) {
      if (kind < 5) recording.temperature_degc[row] = degc[kind];
      if (kind >= 5) recording.rate_dph[row] = dph[kind - 5];
    }
  }
  fog::AcquisitionParameters parameters;
  parameters.sample_period_us = 5000;
  parameters.rate = board_limits({}, 0.005);
  fog::SampleMonitor monitor(parameters);
  Rows board;
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    const auto rate = static_cast<std::int32_t>(std::llround(recording.rate_dph[row] * 1024));
    const auto degc =
        static_cast<std::int32_t>(std::llround(recording.temperature_degc[row] * 65536));
    const fog::SensorSample sample{static_cast<std::uint16_t>(row), rate, degc, true, true};
    const auto verdict = monitor.judge(sample, fog::Rate::from_raw(rate));
    if (verdict.status != fog::Status::none) board.push_back(row);
  }
  EXPECT_EQ(refused(recording), board);
  EXPECT_GT(board.size(), 10000U);
}

TEST(RowJudge, RatesAreRefusedWhereNothingTurnsSoAndOutliersStay) {
  Recording recording = ramps(0.005);
  recording.rate_dph[100] = 500;      // an outlier: the fit weighs it down
  recording.rate_dph[200] = 4e5;      // 111 deg/s in 5 ms
  recording.rate_dph[300] = -2.05e6;  // at full scale
  const std::vector<RefusedRow> rows = refused_rows(recording, {});
  ASSERT_GE(rows.size(), 2U);
  EXPECT_EQ(rows[0].row, 200U);
  EXPECT_EQ(rows[0].why, Refusal::rate_jump);
  EXPECT_EQ(rows[1].row, 300U);
  EXPECT_EQ(rows[1].why, Refusal::rate_beyond_range);
  EXPECT_LE(rows.back().row, 309U) << "50 ms";
  Recording turning = ramps(0.005);  // at 100 deg/s^2 and more, through a spike
  for (std::size_t row = 0; row < turning.rows(); ++row) {
    turning.rate_dph[row] = 1800 * static_cast<double>(std::min<std::size_t>(row, 400));
  }
  turning.rate_dph[200] = -5e5;
  EXPECT_EQ(refused(turning), Rows{200});
  Recording slow = ramps(10);
  slow.rate_dph[100] = 4e5;
  EXPECT_EQ(refused(slow), Rows{}) << "in 10 s anything can turn so";
}

TEST(RowJudge, TheRateIsJudgedByTheLimitsOfTheGyro) {
  Recording recording = ramps(0.005);
  recording.rate_dph[100] = 198 * 3600;
  recording.rate_dph[300] = 15 * 3600;
  const std::vector<RefusedRow> rows = refused_rows(recording, {200, 2000});
  ASSERT_GE(rows.size(), 2U);
  EXPECT_EQ(rows[0].row, 100U);
  EXPECT_EQ(rows[0].why, Refusal::rate_beyond_range);
  EXPECT_EQ(rows.back().row, 300U);
  EXPECT_EQ(rows.back().why, Refusal::rate_jump);
  recording.rate_dph[100] = 90 * 3600;
  EXPECT_TRUE(refused_rows(recording, {}).empty());
}

TEST(RowJudge, AFrozenTemperatureIsFoundInShortRowsAndKept) {
  for (const double period_s : {0.5, 1.0, 10.0}) {
    Recording recording = ramps(period_s);
    const auto first = static_cast<std::size_t>(600 / period_s);
    const auto end = static_cast<std::size_t>(2400 / period_s);
    const double stands = recording.temperature_degc[first];
    for (std::size_t row = first; row < end; ++row) recording.temperature_degc[row] = stands;
    const std::vector<RowRange> frozen = frozen_temperatures(recording);
    ASSERT_EQ(frozen.size(), period_s <= 1 ? 1U : 0U) << period_s;
    if (frozen.empty()) continue;
    EXPECT_NEAR(recording.time_s[frozen[0].first], 600 + 120, 20);
    EXPECT_EQ(frozen[0].end, end);
  }
  EXPECT_TRUE(frozen_temperatures(ramps(0.5)).empty());
}

// As files.

std::string header() {
  return "time_s,temperature_degc,rate_dph\n";
}

std::string line(int time_s, double degc) {
  return std::to_string(time_s) + "," + std::to_string(degc) + ",0.5\n";
}

TEST(RefusedRows, AreNamedWithTheirLinesCountedAndLeftOut) {
  std::string text = "# chamber 3\n" + header();
  for (int i = 0; i < 20; ++i) {
    text += line(10 * i, i % 3 == 1 ? 85 : 20);
    if (i == 5) text += "# pause\n";
  }
  const std::string path = temporary_file("refused.csv", text);
  std::string said;
  const Recording recording = read_recording(path, heard_in(said));
  EXPECT_EQ(
      said,
      path +
          ": 7 samples left out: temperature 85 degC at line 4 (then 7, 11, 14, ...) is what a "
          "DS18B20 says before its first conversion; the board would refuse them\n");
  EXPECT_EQ(recording.refused_rows, 7U);
  EXPECT_EQ(recording.rows(), 13U);
  EXPECT_EQ(recording.rate_dph.size(), 13U);
  EXPECT_EQ(recording.time_s[1], 20);
  EXPECT_EQ(recording.period_s, 10);
  for (const double degc : recording.temperature_degc) EXPECT_EQ(degc, 20);

  ReadOptions options;
  options.keep_refused_rows = true;
  const Recording whole = read_recording(path, options);
  EXPECT_EQ(whole.rows(), 20U) << "the board's own code judges by itself";
  EXPECT_EQ(whole.refused_rows, 0U);
}

// What stands for no reading has one value while others of its column move.
TEST(RefusedRows, OneValueBetweenJumps_Said) {
  const auto said_of = [](const std::function<double(int)>& rate_of) {
    std::string text = header();
    for (int i = 0; i < 600; ++i) text += format("%d,20,%.4f\n", i, rate_of(i));
    std::string said;
    read_recording(temporary_file("stuck.csv", text), heard_in(said));
    return said;
  };
  std::mt19937 random(2);
  std::normal_distribution<double> noise(1, 0.2);
  for (const double value : {0.0, -999.0, 32767.0}) {
    const std::string said =
        said_of([&](int i) { return i >= 300 && i < 360 ? value : noise(random); });
    EXPECT_NE(said.find(format("rate_dph is %g at line 302 and in all 60 rows", value)),
              std::string::npos)
        << said;
    EXPECT_NE(said.find("--mask 300..359"), std::string::npos) << said;
  }
  EXPECT_EQ(said_of([&](int) { return noise(random); }), "");
  EXPECT_EQ(said_of([&](int) { return std::round(noise(random)); }), "") << "coarse";
  EXPECT_EQ(said_of([](int i) { return std::round(1e3 * std::sin(i / 60.0)); }), "") << "smooth";
  EXPECT_EQ(said_of([](int i) { return i < 300 ? 0.0 : 1.0; }), "");
}

// Of a gyro that turns further than its converter goes.
TEST(RefusedRows, EndOfTheScale_Said) {
  const auto said_of = [](double amplitude, double end) {
    std::mt19937 random(2);
    std::normal_distribution<double> noise(0, 1);
    std::string text = header();
    for (int i = 0; i < 2000; ++i) {
      const double rate = amplitude * std::sin(i / 20.0) + noise(random);
      text += format("%d,20,%.2f\n", i, std::max(-end, std::min(end - 1, rate)));
    }
    std::string said;
    read_recording(temporary_file("scale.csv", text), heard_in(said));
    return said;
  };
  for (const double end : {2048.0, 32768.0}) {
    const std::string said = said_of(1.0005 * end, end);
    EXPECT_NE(said.find(format("the rate ends at %g in ", -end)), std::string::npos) << said;
    EXPECT_NE(said.find(format("and %g in ", end - 1)), std::string::npos) << said;
    EXPECT_EQ(said_of(0.9 * end, end), "");
  }
}

// A thermometer that stands still while the coil goes on is seen by the step after it. One that
// came to rest by itself, in a soak without noise or of a coarse sensor, goes on as it came.
TEST(RefusedRows, TemperatureThatStoodWhileTheCoilWentOn_Said) {
  const auto said_of = [](double step_degc, double noise_degc, int stuck_rows) {
    std::mt19937 random(4);
    std::normal_distribution<double> noise(0, 1);
    std::string text = header();
    double held = 0;
    for (int i = 0; i < 2000; ++i) {
      const int in_ramp = i < 500 ? i : i < 1000 ? 500 : i - 500;  // a soak between two ramps
      const double degc = 0.05 * in_ramp + noise_degc * noise(random);
      if (i < 300 || i >= 300 + stuck_rows) held = std::round(degc / step_degc) * step_degc;
      text += format("%d,%.4f,0.5\n", 10 * i, held);
    }
    std::string said;
    read_recording(temporary_file("stood.csv", text), heard_in(said));
    return said;
  };
  EXPECT_NE(said_of(0.004, 0.004, 90).find("temperature_degc is 1"), std::string::npos);
  EXPECT_NE(said_of(0.004, 0.004, 90).find("..3890 leaves"), std::string::npos)
      << said_of(0.004, 0.004, 90);
  EXPECT_EQ(said_of(0.004, 0.004, 0), "");
  EXPECT_EQ(said_of(0.0001, 0, 0), "") << "no noise";
  EXPECT_EQ(said_of(0.0625, 0.004, 0), "") << "coarse";
}

TEST(RefusedRows, LeaveLabelsWhereTheyWere) {
  const auto row = [](int time_s, int degc, const std::string& label) {
    return std::to_string(time_s) + "," + std::to_string(degc) + ",0.5," + label + "\n";
  };
  const Recording recording = read_recording(
      temporary_file("labels.csv", "time_s,temperature_degc,rate_dph,segment\n" + row(0, 85, "a") +
                                       row(1, 20, "a") + row(2, 20, "a") + row(3, 85, "b") +
                                       row(4, 20, "a") + row(5, 20, "c") + row(6, 85, "d")),
      {});
  EXPECT_EQ(recording.time_s, (std::vector<double>{1, 2, 4, 5}));
  ASSERT_EQ(recording.labels.size(), 2U);
  EXPECT_EQ(recording.labels[0].text, "a");
  EXPECT_EQ(recording.labels[0].first_row, 0U);
  EXPECT_EQ(recording.labels[1].text, "c");
  EXPECT_EQ(recording.labels[1].first_row, 3U);
}

TEST(RefusedRows, AreAnErrorWhereNoneIsLeft) {
  std::string text = header();
  for (int i = 0; i < 20; ++i) text += line(i, 293.15);
  try {
    read_recording(temporary_file("kelvin.csv", text), {});
    FAIL();
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("the board would refuse every sample: temperature 293.15 degC at line 2 "
                           "(then 3, 4, 5, ...) is outside -70 to 130 degC; is temperature_degc in "
                           "kelvin? subtract 273.15"),
              std::string::npos)
        << message;
  }
}

// Real recordings, if some are stored beside the project.
TEST(RefusedRows, AreNoneInRealRecordings) {
  for (const char axis : {'x', 'y'}) {
    const std::string path =
        std::string(FOG_SOURCE_DIR) + "/../shared/data/mems_chamber_" + axis + ".csv";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no real recordings here";
    std::string said;
    EXPECT_EQ(read_recording(path, heard_in(said)).refused_rows, 0U);
    EXPECT_EQ(said, "");
  }
}

TEST(Sentinels, ScatteredInTheRate_LeftOut) {
  for (const double sentinel : {-999.0, 0.0, 32767.0}) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> noise(0.7, 0.03);
    std::uniform_real_distribution<double> chance;
    std::string text = "time_s,temperature_degc,rate_dph\n";
    std::size_t good = 0;
    for (int row = 0; row < 3000; ++row) {
      const bool is_read = chance(random) > 0.03;
      text += format("%d,20,%.6f\n", row, is_read ? noise(random) : sentinel);
      if (is_read) ++good;
    }
    std::string said;
    const Recording recording =
        read_recording(temporary_file("sentinel.csv", text), heard_in(said));
    EXPECT_EQ(recording.rows(), good) << said;
    EXPECT_NE(said.find(format("left out: the rate is exactly %g deg/h", sentinel)),
              std::string::npos)
        << said;
  }
}

// Where the noise has values as well.
TEST(Sentinels, AmongTheOthersTooOften_LeftOut) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.02, 0.3);
  std::string text = "time_s,temperature_degc,rate_dph\n";
  for (int row = 0; row < 3000; ++row) {
    text += format("%d,20,%.4f\n", row, row * row % 53 == 0 ? 0 : noise(random));
  }
  std::string said;
  const Recording recording = read_recording(temporary_file("zeros.csv", text), heard_in(said));
  EXPECT_LT(recording.rows(), 2960U);
  EXPECT_NE(said.find("the rate is exactly 0 deg/h, the first at line 2, far more often than "
                      "any value beside it: no readings"),
            std::string::npos)
      << said;
}

// A gyro of this scale on a rate table, whose record has another value in some rows.
Recording on_table(double scale, const std::function<double(int)>& table,
                   const std::function<double(int)>& recorded, std::string& said) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.7, 0.3);
  std::string text = "time_s,temperature_degc,rate_dph,input_rate_dph\n";
  for (int row = 0; row < 3000; ++row) {
    text += format("%d,20,%.4f,%g\n", row, scale * table(row) + noise(random), recorded(row));
  }
  return read_recording(temporary_file("table.csv", text), heard_in(said));
}

TEST(Sentinels, InTheInputRate_LeftOut) {
  const auto table = [](int row) { return row / 500 % 2 == 0 ? 100.0 : -100.0; };
  std::string said;
  const Recording recording = on_table(
      1, table, [&](int row) { return row % 97 == 5 ? -999 : table(row); }, said);
  EXPECT_EQ(recording.rows(), 2969U);
  EXPECT_NE(said.find("31 samples left out: the input rate is exactly -999 deg/h"),
            std::string::npos)
      << said;
}

// A table that stops or turns often, with a gyro whose scale factor is off, and one that rests for
// long and loses some values.
TEST(Sentinels, NoneInAnInputRateThatTheGyroFollows) {
  const auto stops = [](int row) { return row % 20 == 0 ? 0.0 : 36000.0; };
  const auto pulses = [](int row) { return row % 50 == 0 ? 36000.0 : 0.0; };
  const auto rests = [](int row) { return row < 1500 ? 0.0 : 36000.0; };
  std::string said;
  for (const double scale : {1.2, 1.001}) {
    EXPECT_EQ(on_table(scale, stops, stops, said).rows(), 3000U) << said;
    EXPECT_EQ(on_table(scale, pulses, pulses, said).rows(), 3000U) << said;
  }
  const auto with_losses = [&](int row) { return row % 60 == 7 ? 0 : rests(row); };
  EXPECT_EQ(on_table(1, rests, with_losses, said).rows(), 3000U) << said;
}

// A rate in coarse steps, and one that swings between two values.
TEST(Sentinels, NoneInRatesOfFewValues) {
  for (const auto& rate : std::vector<std::function<double(int)>>{
           [](int row) { return row * row % 7 == 0 ? 1.0 : 0.0; },
           [](int row) { return row % 2 == 0 ? 100.0 : 0.0; },
           [](int row) { return row / 50 % 2 == 0 ? 1000 + 0.1 * (row % 3) : 0.1 * (row % 3); }}) {
    std::string text = "time_s,temperature_degc,rate_dph\n";
    for (int row = 0; row < 1000; ++row) text += format("%d,20,%g\n", row, rate(row));
    std::string said;
    EXPECT_EQ(read_recording(temporary_file("few.csv", text), heard_in(said)).rows(), 1000U)
        << said;
  }
}

}  // namespace
}  // namespace fogcomp::recording
