#include "series/zero_phase.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fogcomp::series {
namespace {

BlockSeries series_of(std::size_t blocks, double (*degc_at)(double time_s)) {
  BlockSeries series;
  series.block_s = 10;
  for (std::size_t i = 0; i < blocks; ++i) {
    BlockSeries::Block block;
    block.number = static_cast<std::int64_t>(i);
    block.means.temperature = degc_at(10 * static_cast<double>(i));
    series.blocks.push_back(block);
  }
  return series;
}

TEST(ZeroPhase, IsExactInARampUpToItsEnds) {
  const auto seen =
      zero_phase_signals(series_of(100, [](double time_s) { return 20 + time_s / 60; }), 30);
  // Beyond its ends the ramp is continued for ten time constants.
  for (const double rate : seen.temperature_rate) EXPECT_NEAR(rate, 1, 1e-3);
}

TEST(ZeroPhase, TurnsWhereTheTemperatureTurns) {
  const auto seen = zero_phase_signals(
      series_of(201, [](double time_s) { return std::abs(time_s - 1000) / 60; }), 30);
  EXPECT_NEAR(seen.temperature_rate[100], 0, 1e-9);
  for (std::size_t i = 1; i <= 50; ++i) {
    EXPECT_NEAR(seen.temperature_rate[100 - i], -seen.temperature_rate[100 + i], 1e-9);
  }
}

TEST(ZeroPhase, StartsAnewAfterALongGap) {
  BlockSeries series = series_of(40, [](double) { return 20.0; });
  for (std::size_t i = 20; i < 40; ++i) {
    series.blocks[i].number += 100;
    series.blocks[i].means.temperature = 30;
  }
  const auto seen = zero_phase_signals(series, 30);
  EXPECT_TRUE(seen.restart[0]);
  EXPECT_TRUE(seen.restart[20]);
  EXPECT_FALSE(seen.restart[21]);
  for (const double rate : seen.temperature_rate) EXPECT_NEAR(rate, 0, 1e-9);
}

}  // namespace
}  // namespace fogcomp::series
