// Blocks: interpolation of missing ones between two good ones, means of inputs, their count.
#include "core/thermal/block_bridge.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/pipeline/block_clock.hpp"
#include "core/thermal/extension_averages.hpp"
#include "model/real_numbers.hpp"
#include "support/overflow_guard.hpp"

namespace {

using fog::Input;
using Bridge = fog::BlockBridge<fog::BoardNumbers>;
using Means = Bridge::Means;

Means block_of(std::int32_t raw, std::int32_t number) {
  Means means;
  means.temperature = fog::Temperature::from_raw(raw);
  means.input_rate = fog::Rate::from_raw(-raw);
  means.elapsed = fog::Elapsed::from_raw(number);
  means[Input::magnetic] = fog::ExtensionValue::from_raw(raw);
  return means;
}

TEST(BlockBridge, IsAStraightLineInEverythingThatIsMeasured) {
  Bridge bridge(10);
  bridge.start(block_of(1000, 7));
  ASSERT_TRUE(bridge.bridge_to(block_of(8000, 14), 6));
  ASSERT_EQ(bridge.remaining(), 7U);
  for (std::int32_t i = 1; i <= 7; ++i) {
    const Means& means = bridge.next();
    EXPECT_EQ(means.temperature.raw(), 1000 + 1000 * i);
    EXPECT_EQ(means.input_rate.raw(), -1000 - 1000 * i);
    EXPECT_EQ(means[Input::magnetic].raw(), 1000 + 1000 * i);
    EXPECT_EQ(means.elapsed.raw(), 7 + i);
  }
  EXPECT_EQ(bridge.remaining(), 0U);
}

TEST(BlockBridge, EndsAtTheGoodBlockWhateverWasRounded) {
  Bridge bridge(100);
  bridge.start(block_of(0, 0));
  ASSERT_TRUE(bridge.bridge_to(block_of(-1001, 62), 61));
  double max_off = 0;
  for (int i = 1; i <= 62; ++i) {
    const double expected = -1001.0 * i / 62;
    max_off = std::max(max_off, std::abs(bridge.next().temperature.raw() - expected));
  }
  EXPECT_LT(max_off, 10);  // 0.00015 degC
  ASSERT_TRUE(bridge.bridge_to(block_of(5, 63), 0));
  EXPECT_EQ(bridge.next().temperature.raw(), 5);
}

TEST(BlockBridge, FromOneEndOfTheNumbersToTheOtherNothingOverflows) {
  Bridge bridge(3);
  Means lowest = block_of(INT32_MIN / 2, 0);
  lowest.input_rate = fog::Rate::lowest();
  Means highest = block_of(INT32_MAX / 2, 4);
  highest.input_rate = fog::Rate::highest();
  bridge.start(lowest);
  ASSERT_TRUE(bridge.bridge_to(highest, 3));
  fog::Rate before = fog::Rate::lowest();
  while (bridge.remaining() > 0) {
    const fog::Rate now = bridge.next().input_rate;
    EXPECT_GT(now, before);
    before = now;
  }
  EXPECT_EQ(before, fog::Rate::highest());
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST(BlockBridge, IsNoLongerThanAHold) {
  Bridge bridge(5);
  bridge.start(block_of(0, 0));
  EXPECT_FALSE(bridge.bridge_to(block_of(0, 7), 6));
  EXPECT_EQ(bridge.remaining(), 0U);
  EXPECT_TRUE(bridge.bridge_to(block_of(0, 6), 5));
  bridge.next();
  EXPECT_FALSE(bridge.bridge_to(block_of(0, 7), 1)) << "five are left of the bridge before";
  EXPECT_TRUE(bridge.bridge_to(block_of(0, 6), 0));
  EXPECT_EQ(bridge.remaining(), 6U);
  EXPECT_FALSE(bridge.bridge_to(block_of(0, 9), UINT32_MAX));
}

TEST(BlockBridge, AHoldWithoutEndIsBridgedAsFarAsABoardCounts) {
  Bridge bridge(UINT32_MAX);
  bridge.start(block_of(0, 0));
  EXPECT_FALSE(bridge.bridge_to(block_of(1 << 30, 0), INT32_MAX));
  ASSERT_TRUE(bridge.bridge_to(block_of(1 << 30, 0), INT32_MAX - 1));
  EXPECT_EQ(bridge.next().temperature.raw(), 0);
  EXPECT_EQ(bridge.remaining(), static_cast<std::uint32_t>(INT32_MAX) - 1);
}

TEST(BlockBridge, InputThatTheImageLacks_LeftAsItWas) {
  fog::BlockBridge<fog::BoardNumbers, fog::bit_of(Input::magnetic)> bridge(10);
  Means first = block_of(1000, 0);
  bridge.start(first);
  Means second = block_of(3000, 2);
  second[Input::supply] = fog::ExtensionValue::from_raw(3000);
  ASSERT_TRUE(bridge.bridge_to(second, 1));
  const Means& halfway = bridge.next();
  EXPECT_EQ(halfway[Input::magnetic].raw(), 2000);
  EXPECT_EQ(halfway[Input::supply], first[Input::supply]);
}

TEST(ExtensionAverages, InputThatTheModelDoesNotNeed_NotAveraged) {
  fog::ExtensionAverages<fog::kAllExtensionInputs> averages(fog::bit_of(Input::magnetic));
  averages.add(Input::supply, fog::ExtensionValue::from_raw(7));
  EXPECT_FALSE(averages.has_all());
  averages.add(Input::magnetic, fog::ExtensionValue::from_raw(9));
  EXPECT_TRUE(averages.has_all());
  EXPECT_EQ(averages.means()[fog::extension_number(Input::magnetic)].raw(), 9);
  EXPECT_EQ(averages.means()[fog::extension_number(Input::supply)].raw(), 0);
}

TEST(BlockClock, After68Years_Stands) {
  fog::BlockClock clock(1);
  clock.advance(INT32_MAX);
  EXPECT_EQ(clock.elapsed(), fog::Elapsed::highest());
  EXPECT_EQ(clock.advance(INT32_MAX), static_cast<std::uint32_t>(INT32_MAX));
  EXPECT_EQ(clock.elapsed(), fog::Elapsed::highest());
}

TEST(BlockBridge, OnTheHostIsTheSameLine) {
  fog::BlockBridge<fogcomp::model::RealNumbers> bridge(10);
  fog::BlockMeans<fogcomp::model::RealNumbers> means{10, 1, 5, {}};
  bridge.start(means);
  means = {13, -2, 8, {}};
  ASSERT_TRUE(bridge.bridge_to(means, 2));
  for (int i = 1; i <= 3; ++i) {
    const auto& next = bridge.next();
    EXPECT_NEAR(next.temperature, 10 + i, 1e-12);
    EXPECT_NEAR(next.input_rate, 1 - i, 1e-12);
    EXPECT_NEAR(next.elapsed, 5 + i, 1e-12);
  }
}

}  // namespace
