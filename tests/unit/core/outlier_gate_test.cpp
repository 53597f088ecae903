#include "core/denoise/outlier_gate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace {

constexpr std::uint32_t kLimit = 100;

/// A gate in front of a line of eight samples, all 1000.
struct Gated {
  Gated() {
    line.fill(1000, kWindow);
    gate.set_limit(kLimit);
  }
  void push(std::int32_t sample) { gate.push(line, sample); }
  std::int32_t newest(std::size_t back = 0) const { return line.newest()[back]; }

  static constexpr std::size_t kLength = 8;
  static constexpr std::size_t kWindow = 4;
  std::array<std::int32_t, fog::SampleLine::memory(kLength, kWindow)> memory{};
  fog::SampleLine line{memory.data(), kLength, kWindow};
  fog::OutlierGate gate;
};

TEST(OutlierGate, WithholdsWhatJumpsByMoreThanTheLimitUntilTheNextTells) {
  for (const std::int32_t sign : {1, -1}) {
    Gated at_limit;
    at_limit.push(1000 + sign * 100);
    EXPECT_EQ(at_limit.newest(), 1000 + sign * 100);

    Gated beyond;
    beyond.push(1000 + sign * 101);
    EXPECT_EQ(beyond.newest(), 1000);
    EXPECT_EQ(beyond.gate.last(beyond.line), 1000 + sign * 101);
    EXPECT_TRUE(beyond.gate.watched());
    beyond.push(1000);  // back: an outlier, whose stand-in stays
    EXPECT_FALSE(beyond.gate.valid());
    EXPECT_EQ(beyond.newest(), 1000);
    EXPECT_EQ(beyond.newest(1), 1000);
    EXPECT_EQ(beyond.gate.last(beyond.line), 1000);

    Gated step;
    step.push(1000 + sign * 101);
    step.push(1000 + sign * 101);  // it stays: no outlier
    EXPECT_TRUE(step.gate.valid());
    EXPECT_EQ(step.newest(), 1000 + sign * 101);
    EXPECT_EQ(step.newest(1), 1000 + sign * 101);
  }
}

TEST(OutlierGate, AnOutlierStandsOffByMoreThanLimitAndDifferencesTogether) {
  for (const std::int32_t sign : {1, -1}) {
    // Samples 1000, 1000 + before, outlier, 1000 + before + after.
    const auto kept = [&](std::int32_t before, std::int32_t off, std::int32_t after) {
      Gated gated;
      const std::int32_t last = 1000 + sign * before;
      gated.push(last);
      gated.push(last + sign * off);
      gated.push(last - sign * after);
      return gated.newest(1) == last;
    };
    EXPECT_TRUE(kept(0, 101, 0));
    EXPECT_FALSE(kept(40, 140, 0));
    EXPECT_TRUE(kept(40, 141, 0));
    EXPECT_TRUE(kept(-40, 141, 0));
    EXPECT_FALSE(kept(40, 140 + 30, 30));
    EXPECT_TRUE(kept(40, 141 + 30, 30));
    EXPECT_FALSE(kept(0, 100 + 2 * 30, -30));  // the neighbour towards it counts
    EXPECT_TRUE(kept(0, 101 + 2 * 30, -30));
  }
}

TEST(OutlierGate, ALimitSetWhileASampleIsWithheldHoldsFromTheNextOn) {
  Gated gated;
  gated.push(1200);
  gated.gate.set_limit(300);
  EXPECT_EQ(gated.gate.last(gated.line), 1200);
  gated.push(1000);  // within the new limit it was no outlier
  EXPECT_EQ(gated.newest(1), 1200);
  gated.push(1300);
  EXPECT_EQ(gated.newest(), 1300);
}

TEST(OutlierGate, LetsEverythingPassWithoutALimitAndTakesTheWholeRange) {
  Gated open;
  open.gate.set_limit(0);
  for (const std::int32_t sample : {INT32_MIN, INT32_MAX, 0, -1}) {
    open.push(sample);
    EXPECT_EQ(open.newest(), sample);
  }
  Gated gated;
  gated.push(INT32_MAX);
  gated.push(INT32_MIN);
  EXPECT_EQ(gated.newest(1),
            INT32_MAX);  // stands off no further than its neighbours from each other
}

}  // namespace
