// What moves the temperature of a recording.
#include "recording/segments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "recording/recording.hpp"

namespace fogcomp::recording {
namespace {

constexpr double kHour = 3600;

// A sample each 10 s, with a thermometer's noise.
Recording recorded(double hours, const std::function<double(double time_s)>& degc,
                   double noise_degc = 0.02) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise;
  Recording recording;
  recording.file = "run.csv";
  recording.period_s = 10;
  recording.stretch_starts = {0};
  for (double time_s = 0; time_s < hours * kHour; time_s += 10) {
    recording.time_s.push_back(time_s);
    recording.temperature_degc.push_back(degc(time_s) + noise_degc * noise(random));
    recording.rate_dph.push_back(1);
  }
  return recording;
}

std::string course_of(double hours, const std::function<double(double time_s)>& degc,
                      double noise_degc = 0.02) {
  return course_name(temperature_course(recorded(hours, degc, noise_degc)));
}

double ramp_and_soak(double time_s, double from, double to, double degc_per_min) {
  const double there = std::fabs(to - from) / degc_per_min * 60;
  return time_s < there ? from + (to - from) * time_s / there : to;
}

TEST(TemperatureCourse, OwnHeat_Settles) {
  for (const double tau_s : {100.0, 400.0, 1500.0}) {
    const auto warms = [tau_s](double t) { return 60 - 50 * std::exp(-t / tau_s); };
    EXPECT_EQ(course_of(2, warms), "settling") << tau_s;
    EXPECT_NEAR(settling_time_s(recorded(2, warms)), tau_s, 0.1 * tau_s + 10) << tau_s;
  }
  // Die and housing; and cooling, with a coarse sensor.
  EXPECT_EQ(
      course_of(2, [](double t) { return 45 - 8 * std::exp(-t / 60) - 15 * std::exp(-t / 1200); }),
      "settling");
  EXPECT_EQ(course_of(
                3, [](double t) { return std::round(20 + 30 * std::exp(-t / 900)); }, 0),
            "settling");
}

TEST(TemperatureCourse, Chamber_Programme) {
  EXPECT_EQ(course_of(4, [](double t) { return ramp_and_soak(t, 20, 60, 1); }), "programme");
  EXPECT_EQ(course_of(12,
                      [](double t) {
                        const double part = std::fmod(t, 4 * kHour);
                        return t < 4 * kHour   ? ramp_and_soak(part, 20, -40, 0.5)
                               : t < 8 * kHour ? ramp_and_soak(part, -40, 60, 1)
                                               : ramp_and_soak(part, 60, 20, 1);
                      }),
            "programme");
  EXPECT_EQ(course_of(48, [](double t) { return 10 + 40 * t / (48 * kHour); }), "programme");
}

TEST(TemperatureCourse, Surroundings_AreTold) {
  constexpr double kPi = 3.14159265;
  EXPECT_EQ(course_of(26, [](double t) { return 15 - 10 * std::cos(2 * kPi * t / (24 * kHour)); }),
            "day");
  EXPECT_EQ(course_of(72,
                      [](double t) {
                        const double turn = 2 * kPi * t / (24 * kHour);
                        return 18 - 6 * std::cos(turn) + 1.5 * std::sin(2 * turn);
                      }),
            "day");
  EXPECT_EQ(
      course_of(1, [](double t) { return 30 + 5 * std::sin(t / 300) + 2 * std::sin(t / 110 + 1); }),
      "free");
  EXPECT_EQ(course_of(10, [](double) { return 25; }), "steady");
}

// A logger that is off at times sees the same programme.
TEST(TemperatureCourse, Pauses_ChangeNothing) {
  const auto degc = [](double t) { return 50 - std::fabs(t - 4 * kHour) / 480; };
  for (const double off_s : {60.0, 540.0, 1800.0}) {
    for (const double on_s : {60.0, 540.0}) {
      Recording recording;
      recording.period_s = 1;
      for (double time_s = 0; time_s < 8 * kHour; ++time_s) {
        const double within_s = std::fmod(time_s, on_s + off_s);
        if (within_s >= on_s) continue;
        if (within_s == 0) recording.stretch_starts.push_back(recording.rows());
        recording.time_s.push_back(time_s);
        recording.temperature_degc.push_back(degc(time_s));
        recording.rate_dph.push_back(1);
      }
      const std::string course = course_name(temperature_course(recording));
      EXPECT_NE(course, "steady") << on_s << " " << off_s;
      if (off_s > 600) continue;  // longer than a logger's period
      for (const Segment& segment : find_segments(recording)) {
        EXPECT_NE(segment.kind, SegmentKind::soak) << segment.name << on_s << " " << off_s;
      }
    }
  }
}

}  // namespace
}  // namespace fogcomp::recording
