#include "recording/reading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/input_error.hpp"
#include "support/text.hpp"
#include "temporary_file.hpp"

namespace fogcomp::recording {
namespace {

// Two soaks and a ramp of 1 degC/min between them, a row every 10 s; times in `per_second`.
Recording chamber_run(double per_second) {
  std::string text = "time_s,temperature_degc,rate_dph\n";
  for (int row = 0; row < 720; ++row) {
    const double minutes = row / 6.0;
    const double degc = 20 + std::clamp(minutes - 40, 0.0, 40.0);
    text += format("%.4f,%.4f,%.3f\n", 10 * row * per_second, degc, 0.1 * (row % 3));
  }
  return read_recording(temporary_file("chamber.csv", text), {});
}

std::string doubts_of(const Recording& recording, double noise_dph_rthz = 0.06) {
  return join(doubts(recording, noise_dph_rthz), "\n");
}

TEST(Plausibility, OfAGyroInAChamberIsNotDoubted) {
  EXPECT_EQ(doubts_of(chamber_run(1)), "");
  // From the best fibre gyros to cheap MEMS ones; zero noise suggests no unit.
  for (const double noise_dph_rthz : {0.0, 0.004, 0.06, 6.0, 60.0, 600.0}) {
    EXPECT_EQ(doubts_of(chamber_run(1), noise_dph_rthz), "") << noise_dph_rthz;
  }
}

TEST(Plausibility, OfARateInAnotherUnitIsDoubted) {
  EXPECT_NE(
      doubts_of(chamber_run(1), 0.06 / 3600).find("noise of 2.8e-07 deg/sqrt(h) is less than"),
      std::string::npos);
  EXPECT_NE(doubts_of(chamber_run(1), 0.06 / 206265).find("or in deg/s or rad/s?"),
            std::string::npos);
  EXPECT_NE(doubts_of(chamber_run(1), 1e5).find("is more than any gyro has"), std::string::npos);
}

TEST(Plausibility, OfARateThatOnlyGrowsIsDoubted) {
  for (const double sign : {1.0, -1.0}) {
    Recording run = chamber_run(1);
    run.rate_dph.assign(run.rows(), 0.5);
    EXPECT_EQ(doubts_of(run), "");
    for (std::size_t row = 0; row < run.rows(); ++row) {
      run.rate_dph[row] = sign * static_cast<double>(row + row % 2);
    }
    EXPECT_NE(doubts_of(run).find("is it an angle that is counted on?"), std::string::npos);
    run.rate_dph[100] = 0;
    EXPECT_EQ(doubts_of(run), "");
  }
}

TEST(Plausibility, OfATimeInAnotherUnitIsDoubted) {
  const std::string ms = doubts_of(chamber_run(1000));
  EXPECT_NE(ms.find("is the time in s, or in ms?"), std::string::npos) << ms;
  EXPECT_NE(ms.find("the temperature goes through 40 degC at 0.06 degC/h at most"),
            std::string::npos)
      << ms;
  const std::string min = doubts_of(chamber_run(1.0 / 60));
  EXPECT_NE(min.find("as no chamber can move a coil: is the time in s, or in min or h?"),
            std::string::npos)
      << min;
  EXPECT_NE(doubts_of(chamber_run(1.0 / 3600)).find("as no chamber can move a coil"),
            std::string::npos);
  EXPECT_NE(doubts_of(chamber_run(5000)).find("a run of 9986 h"), std::string::npos);
}

std::string read_refusal(const std::string& content, ReadOptions options = {}) {
  try {
    read_recording(temporary_file("doubt.csv", content), options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// A rate table whose record is so many times what the gyro sees.
std::string turned(double times) {
  std::string text = "time_s,temperature_degc,rate_dph,input_rate_dph\n";
  for (int row = 0; row < 600; ++row) {
    const double turn = 36000 * (row / 100 % 3 - 1);
    text += format("%d,20,%.3f,%.9g\n", row, turn + row * row % 17, turn * times);
  }
  return text;
}

TEST(Plausibility, InputRateInAnotherUnit_Asked) {
  EXPECT_EQ(read_refusal(turned(1)), "");
  EXPECT_EQ(read_refusal(turned(1.1)), "");
  const std::string of_degrees = read_refusal(turned(1 / 3600.0));
  EXPECT_NE(of_degrees.find("its rate changes by 3600 where its input rate changes by 1: one of "
                            "them has another unit or sign; say which: --columns "
                            "'input_rate=input_rate_dph[deg/h]' if it is right or "
                            "'input_rate=input_rate_dph[deg/s]'"),
            std::string::npos)
      << of_degrees;
  const std::string of_sign = read_refusal(turned(-1));
  EXPECT_NE(of_sign.find("'input_rate=input_rate_dph[-deg/h]' or 'rate=rate_dph[-deg/h]'"),
            std::string::npos)
      << of_sign;
  for (const char* columns : {"input_rate=input_rate_dph[deg/h]", "input_rate=4[-deg/h]"}) {
    ReadOptions options;
    options.columns = columns;
    EXPECT_EQ(read_refusal(turned(-1), options), "") << columns;
  }
}

// A swing that is seen half a period late.
TEST(Plausibility, LateInputRate_NotOnlyOfAnotherSign) {
  std::string text = "time_s,temperature_degc,rate_dph,input_rate_dph\n";
  for (int row = 0; row < 600; ++row) {
    const auto swing = [](double time_s) { return 36000 * std::sin(time_s * 3.14159 / 20); };
    text += format("%d,20,%.3f,%.9g\n", row, swing(row - 20) + row * row % 17, swing(row));
  }
  EXPECT_NE(read_refusal(text).find("one of them is late, or has another unit or sign"),
            std::string::npos)
      << read_refusal(text);
}

}  // namespace
}  // namespace fogcomp::recording
