#include "findings/findings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "report/report.hpp"

namespace fogcomp::findings {
namespace {

recording::Recording turned(double scale_factor_ppm) {
  recording::Recording recording;
  recording.file = "table.csv";
  recording.period_s = 10;
  recording.stretch_starts = {0};
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 1);
  for (int i = 0; i < 400; ++i) {
    const double rate_dph = 36000 * std::sin(i / 9.0);
    recording.time_s.push_back(10 * i);
    recording.temperature_degc.push_back(20);
    recording.input_rate_dph.push_back(rate_dph);
    recording.rate_dph.push_back(rate_dph * (1 + 1e-6 * scale_factor_ppm) + noise(random));
  }
  return recording;
}

std::string info(const recording::Recording& recording) {
  return report::terminal(info_findings(recording, compare::summarize(recording, 10)));
}

// 100 ppm of 25,000 deg/h rms are 2.5 deg/h beside 1 deg/h of noise: 86 %.
TEST(InfoOnATerminal, SaysHowMuchOfTheBiasGoesWithTheInputRate) {
  EXPECT_NE(info(turned(100)).find("the input rate explains 8"), std::string::npos)
      << info(turned(100));
  EXPECT_NE(info(turned(0)).find("the input rate explains 3 %"), std::string::npos)
      << info(turned(0));
  recording::Recording still = turned(0);
  still.input_rate_dph.assign(still.rows(), 0);
  EXPECT_EQ(info(still).find("input rate explains"), std::string::npos);
}

}  // namespace
}  // namespace fogcomp::findings
