#include "recording/reading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "recording/recording.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "unit/recording/heard_in.hpp"
#include "unit/recording/temporary_file.hpp"

namespace fogcomp::recording {
namespace {

constexpr double kPeriod = 0.01;

// When a sample that was taken at a time arrives.
using Arrival = std::function<double(double sampled_s)>;

// 60,000 samples at 100 Hz of which a share is lost, each as it arrives, in order.
struct Arrived {
  std::vector<double> sampled_s;
  std::vector<double> stamp_s;
  std::size_t lost = 0;  // pauses in sampled_s
};

Arrived arrived(const Arrival& arrival, double lost = 0) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> chance;
  Arrived result;
  for (int i = 0; i < 60000; ++i) {
    const double sampled_s = i * kPeriod;
    if (chance(random) < lost) continue;
    if (!result.sampled_s.empty() && sampled_s - result.sampled_s.back() > 1.5 * kPeriod) {
      ++result.lost;
    }
    result.sampled_s.push_back(sampled_s);
    const double stamp_s = arrival(sampled_s);
    result.stamp_s.push_back(result.stamp_s.empty() ? stamp_s
                                                    : std::max(stamp_s, result.stamp_s.back()));
  }
  return result;
}

double in_packets(double sampled_s, int samples) {
  const double packet_s = samples * kPeriod;
  return std::ceil((sampled_s + kPeriod / 2) / packet_s) * packet_s;
}

// Of a reader that stands still for 0.2 s at times, after which it finds all that waited.
Arrival stalled() {
  return [random = std::mt19937_64(3), until_s = 0.0](double sampled_s) mutable {
    std::uniform_real_distribution<double> chance;
    if (chance(random) < 0.01 && sampled_s > until_s) until_s = sampled_s + 0.2;
    return std::max(sampled_s + 1e-4 * chance(random), until_s);
  };
}

struct Delays {
  const char* name;
  Arrival arrival;
};

std::vector<Delays> all_delays() {
  return {
      {"packets of 10", [](double t) { return in_packets(t, 10); }},
      {"packets, 2 ms between samples",
       [](double t) {
         const double packet_s = std::floor((t + 1e-9) / 0.1) * 0.1;
         return packet_s + (t - packet_s) * 0.2;
       }},
      {"packets of 7 with jitter",
       [random = std::mt19937_64(1)](double t) mutable {
         return in_packets(t, 7) + std::uniform_real_distribution<double>(0, 0.005)(random);
       }},
      {"stalls", stalled()},
      {"a clock of 1 s", [](double t) { return std::floor(t + 1e-9); }},
  };
}

TEST(ArrivalStamps, LateSamples_EvenAtTheTrueRate) {
  for (const Delays& each : all_delays()) {
    const Arrived samples = arrived(each.arrival);
    const auto even = even_times(samples.stamp_s);
    ASSERT_TRUE(even && even->is_known) << each.name;
    EXPECT_EQ(even->gaps_after, 0U) << each.name;
    EXPECT_GT(even->uneven_before, 0U) << each.name;
    EXPECT_NEAR(even->rate_hz, 100, 0.01) << each.name;
    EXPECT_LT(even->rate_sigma_hz, 0.015) << each.name;
    EXPECT_GT(even->rate_sigma_hz, 1e-9) << each.name;  // stamps that agree by their rounding
    for (std::size_t i = 1; i < even->time_s.size(); ++i) {
      ASSERT_NEAR(even->time_s[i] - even->time_s[i - 1], kPeriod, kPeriod / 4)
          << each.name << " at " << samples.sampled_s[i];
    }
  }
}

TEST(ArrivalStamps, LateAndLostSamples_GapsWhereTheyAreLost) {
  for (const Delays& each : all_delays()) {
    if (each.name == std::string("a clock of 1 s")) continue;  // does not tell where
    Arrived samples = arrived(each.arrival);
    // Two pauses of half a minute and 40 samples.
    for (const std::size_t at : {std::size_t{40000}, std::size_t{15000}}) {
      for (auto* times : {&samples.sampled_s, &samples.stamp_s}) {
        times->erase(
            times->begin() + static_cast<std::ptrdiff_t>(at),
            times->begin() + static_cast<std::ptrdiff_t>(at == 15000 ? at + 40 : at + 3000));
      }
    }
    const auto even = even_times(samples.stamp_s);
    ASSERT_TRUE(even && even->is_known) << each.name;
    EXPECT_EQ(even->gaps_after, 2U) << each.name;
    EXPECT_NEAR(even->rate_hz, 100, 0.02) << each.name;
  }
}

// The count of each loss is known, its place to the time between two anchors.
TEST(ArrivalStamps, LateSamplesOfWhichSomeAreLost_EvenAtTheTrueRate) {
  for (const Delays& each : all_delays()) {
    if (each.name == std::string("a clock of 1 s")) continue;
    for (const double lost : {0.001, 0.01, 0.03}) {
      const std::string what = each.name + format(", %g lost", lost);
      const Arrived samples = arrived(each.arrival, lost);
      if (each.name == std::string("stalls") && lost > 0.001) continue;  // most gaps are gaps
      const auto even = even_times(samples.stamp_s);
      ASSERT_TRUE(even && even->is_known) << what;
      EXPECT_NEAR(even->rate_hz, 100, std::max(5 * even->rate_sigma_hz, 1e-4)) << what;
      EXPECT_LE(even->gaps_after, samples.lost) << what;
      EXPECT_NEAR(even->time_s.back() - even->time_s.front(),
                  samples.sampled_s.back() - samples.sampled_s.front(), 5 * kPeriod)
          << what;
    }
  }
}

TEST(ArrivalStamps, SoManyLostThatNoRateIsTold_Asked) {
  const std::vector<double> stamps =
      arrived([](double t) { return in_packets(t, 10); }, 0.2).stamp_s;
  const auto even = even_times(stamps);
  ASSERT_TRUE(even);
  EXPECT_FALSE(even->is_known);
  const auto given = even_times(stamps, 100);
  ASSERT_TRUE(given && given->is_known);
  EXPECT_NEAR(given->rate_hz, 100, 0.01);
}

// Packets of all sizes, late by up to half of themselves, of which samples or whole packets are
// lost.
TEST(ArrivalStamps, BurstsOfWhichSomeAreLost_RightRateOrAsked) {
  std::mt19937_64 random(11);
  const auto one_of = [&](std::vector<double> values) { return values[random() % values.size()]; };
  std::uniform_real_distribution<double> chance;
  int told = 0;
  for (int draw = 0; draw < 100; ++draw) {
    const int samples = static_cast<int>(one_of({2, 3, 5, 10, 20}));
    const double jitter_s = one_of({0, 0.1, 0.3, 0.5}) * samples * kPeriod;
    const double within_s = one_of({0, 0.0005, 0.002, 0.005});
    const double lost = one_of({0.02, 0.1, 0.2, 0.3});
    const bool in_packets = random() % 2 == 0;
    std::vector<double> stamps;
    double late_s = 0;
    bool is_lost = false;
    for (int i = 0; i < 20000; ++i) {
      if (i % samples == 0) late_s = jitter_s * chance(random);
      if (i % samples == 0 || !in_packets) is_lost = chance(random) < lost;
      const double stamp_s =
          (i / samples + 1) * samples * kPeriod + late_s + i % samples * within_s;
      if (!is_lost) stamps.push_back(std::max(stamp_s, stamps.empty() ? 0 : stamps.back()));
    }
    const std::string what =
        format("packets of %d, %g s late, %g s between, %g of %s lost", samples, jitter_s, within_s,
               lost, in_packets ? "packets" : "samples");
    const auto even = even_times(stamps);
    Recording as_it_is;
    as_it_is.time_s = stamps;
    if (even && even->is_known) {
      EXPECT_NEAR(even->rate_hz, 100, 1) << what;
      ++told;
    } else if (!even) {
      find_stretches(as_it_is);
      EXPECT_NEAR(1 / as_it_is.period_s, 100, 1) << what;
    }
    const auto given = even_times(stamps, 100);
    EXPECT_TRUE(!given || given->is_known) << what;
    if (given) {
      EXPECT_NEAR(given->rate_hz, 100, 1) << what;
    }
  }
  EXPECT_GE(told, 8);
}

TEST(ArrivalStamps, LostSamples_LeftAsTheyAre) {
  for (const double lost : {0.0005, 0.005, 0.02, 0.05, 0.1, 0.3, 0.5}) {
    EXPECT_FALSE(even_times(arrived([](double t) { return t; }, lost).stamp_s)) << lost;
  }
}

// A radio that fades for 2 to 50 samples: more is lost than by itself, and nothing is late.
TEST(ArrivalStamps, LostTogether_LeftAsTheyAre) {
  for (const int samples : {2, 5, 20, 50}) {
    for (const double lost : {0.02, 0.1, 0.3}) {
      std::mt19937_64 random(4);
      std::uniform_real_distribution<double> chance;
      std::vector<double> stamps;
      for (int i = 0; i < 60000; ++i) {
        if (chance(random) < lost / samples) i += samples;
        stamps.push_back(i * kPeriod);
      }
      EXPECT_FALSE(even_times(stamps)) << samples << ' ' << lost;
    }
  }
}

TEST(ArrivalStamps, OtherTimes_LeftAsTheyAre) {
  const std::vector<double> even = arrived([](double t) { return t; }).stamp_s;
  EXPECT_FALSE(even_times(even));
  EXPECT_FALSE(even_times({}));
  EXPECT_FALSE(even_times({0}));
  EXPECT_FALSE(even_times({0, 0, 1}));
  std::vector<double> slower = even;  // from the middle on at half the rate
  for (std::size_t i = 30000; i < slower.size(); ++i) slower[i] += slower[i] - even[30000];
  const auto asked = even_times(slower);
  EXPECT_TRUE(asked && !asked->is_known);
  std::vector<double> bursts;  // a second of samples each minute
  for (int i = 0; i < 20000; ++i) bursts.push_back(i / 100 * 60 + i % 100 * kPeriod);
  EXPECT_FALSE(even_times(bursts));
}

// A logger that pauses in a rhythm: what it wrote came in time.
TEST(ArrivalStamps, RegularPauses_RateOfTheSamples) {
  for (const auto& [samples, pause] : {std::pair(7, 3), {70, 30}, {20, 1}, {3, 1}}) {
    Recording recording;
    for (int i = 0; i < 20000; ++i) {
      if (i % (samples + pause) < samples) recording.time_s.push_back(i * kPeriod);
    }
    EXPECT_FALSE(even_times(recording.time_s)) << samples;
    find_stretches(recording);
    EXPECT_NEAR(recording.period_s, kPeriod, 1e-6) << samples;
  }
}

std::string file_of(const std::vector<double>& time_s) {
  std::string text = "time_s,temperature_degc,rate_dph\n";
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    text += format("%.4f,%.3f,%zu\n", time_s[i], 20 + 1e-4 * static_cast<double>(i), i % 17);
  }
  return text;
}

TEST(ArrivalStamps, FileOfPackets_ReadAtTheTrueRate) {
  std::string said;
  const Arrived samples = arrived([](double t) { return in_packets(t, 10); });
  const Recording recording =
      read_recording(temporary_file("packets.csv", file_of(samples.stamp_s)), heard_in(said));
  EXPECT_NEAR(recording.period_s, kPeriod, 1e-6);
  EXPECT_EQ(recording.stretch_starts.size(), 1U) << said;
  EXPECT_NE(said.find("packets.csv: times are those at which samples arrived; taken as even, at "
                      "100 +- "),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("uneven spacings, 0 gaps"), std::string::npos) << said;
}

TEST(ArrivalStamps, FileWhoseLossesHideTheRate_RefusedUntilItIsGiven) {
  const Arrived samples = arrived([](double t) { return in_packets(t, 10); }, 0.2);
  const std::string path = temporary_file("lost.csv", file_of(samples.stamp_s));
  ReadOptions options;
  try {
    read_recording(path, options);
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("give --rate HZ"), std::string::npos) << error.what();
  }
  options.stream_rate_hz = 100;
  EXPECT_NEAR(read_recording(path, options).period_s, kPeriod, 1e-5);
}

TEST(ArrivalStamps, RepeatedTimeThatIsNoPacket_Refused) {
  std::vector<double> time_s = arrived([](double t) { return t; }).stamp_s;
  time_s[5] = time_s[4];
  try {
    read_recording(temporary_file("repeat.csv", file_of(time_s)), {});
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("repeat.csv:7: time_s repeats 0.04"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace fogcomp::recording
