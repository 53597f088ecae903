#include "compare/dependence.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/compare/slow_noise.hpp"

namespace fogcomp::compare {
namespace {

constexpr std::size_t kRows = 4000;
constexpr std::size_t kBins = 20;

// Down, up and back: 20, -40, 60, 20 degC with soaks between, as in a chamber.
std::vector<double> chamber_cycle() {
  std::vector<double> degc;
  const auto to = [&](double from, double target, std::size_t ramp, std::size_t soak) {
    for (std::size_t i = 0; i < ramp; ++i) {
      degc.push_back(from + (target - from) * static_cast<double>(i) / static_cast<double>(ramp));
    }
    degc.insert(degc.end(), soak, target);
  };
  degc.insert(degc.end(), 400, 20);
  to(20, -40, 700, 300);
  to(-40, 60, 1200, 400);
  to(60, 20, 600, 400);
  return degc;
}

// Residual = 0.02 deg/h of noise + `shape` of row number and temperature.
template <class Shape>
ResidualRows residual_of(const std::vector<double>& degc, double phi, std::uint64_t seed,
                         Shape shape) {
  ResidualRows rows;
  rows.stretches = {{0, degc.size()}};
  rows.noise.row_s = 10;
  if (phi > 0) rows.noise.components = {{-10 / std::log(phi), 4e-4}};
  rows.noise.white_variance = phi > 0 ? 1e-9 : 4e-4;
  rows.residual_dph = fog::test::slow_noise(degc.size(), phi, seed);
  for (std::size_t i = 0; i < degc.size(); ++i) {
    rows.time_s.push_back(10 * static_cast<double>(i));
    rows.residual_dph[i] = 0.02 * rows.residual_dph[i] + shape(i, degc[i]);
  }
  return rows;
}

double no_shape(std::size_t /*row*/, double /*degc*/) {
  return 0;
}

TEST(Dependence, MeasuresACurveAndItsVariance) {
  const auto degc = chamber_cycle();
  ASSERT_EQ(degc.size(), kRows);
  const auto line = [](std::size_t /*row*/, double t) { return 1e-3 * (t - 10); };
  const auto rows = residual_of(degc, 0, 1, line);
  const auto found = dependence_on(degc, rows, kBins);
  EXPECT_TRUE(found.test.structured());
  double variance = 0;
  for (const double t : degc) variance += std::pow(line(0, t), 2);
  double mean = 0;
  for (const double t : degc) mean += line(0, t);
  variance = variance / kRows - std::pow(mean / kRows, 2);
  EXPECT_NEAR(found.test.variance_dph2, variance, 0.05 * variance);
  for (const auto& bin : found.bins) {
    EXPECT_NEAR(bin.mean_dph, line(0, bin.at), 5 * bin.sigma_dph);
  }
}

// Noise alone, white and slow (correlated over tens of rows), against temperature and history:
// called structured in few of 200 runs each.
TEST(Dependence, TakesNoiseForNoise) {
  const auto degc = chamber_cycle();
  for (const double phi : {0.0, 0.9}) {
    int temperature = 0;
    int history = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      const auto rows = residual_of(degc, phi, seed, no_shape);
      if (dependence_on(degc, rows, kBins).test.structured()) ++temperature;
      if (loop_over(degc, rows, kBins).test.structured()) ++history;
    }
    std::printf("phi %.1f: temperature %d, history %d of 200 falsely structured\n", phi,
                temperature, history);
    EXPECT_LE(temperature, 6);
    EXPECT_LE(history, 6);
  }
}

TEST(Dependence, LeavesOutBinsWithFewRows) {
  std::vector<double> variable(100, 0);
  variable[50] = 1;
  const auto spike = [](std::size_t row, double /*degc*/) { return row == 50 ? 5.0 : 0.0; };
  const auto found = dependence_on(variable, residual_of(variable, 0, 1, spike), 10);
  ASSERT_EQ(found.bins.size(), 1U);
  EXPECT_EQ(found.bins[0].rows, 99U);
  EXPECT_FALSE(found.test.structured());
}

// A loop that stays in the soaks, as rate-independent hysteresis does.
TEST(Loop, HasTheWidthOfTheHysteresis) {
  const auto degc = chamber_cycle();
  // Cooling from row 400 on, heating from row 1400 on, cooling from row 3000 on.
  const auto hysteresis = [](std::size_t row, double /*degc*/) {
    if (row < 400) return 0.0;
    return row >= 1400 && row < 3000 ? 0.015 : -0.015;
  };
  const auto loop = loop_over(degc, residual_of(degc, 0, 1, hysteresis), kBins);
  EXPECT_TRUE(loop.test.structured());
  ASSERT_NE(loop.widest(), nullptr);
  double sum = 0;
  for (const auto& bin : loop.bins) {
    // The first degree after a turning point still belongs to the preceding branch.
    if (bin.at_degc < -35 || bin.at_degc > 55) continue;
    EXPECT_NEAR(bin.width_dph(), 0.03, 5 * bin.sigma_dph);
    sum += bin.width_dph();
  }
  EXPECT_GT(sum, 0);
}

TEST(Loop, IsNotSeenInACurveOverTemperature) {
  const auto degc = chamber_cycle();
  const auto rows =
      residual_of(degc, 0, 1, [](std::size_t /*row*/, double t) { return 1e-3 * (t - 10); });
  EXPECT_FALSE(loop_over(degc, rows, kBins).test.structured());
}

TEST(Loop, NeedsBothBranches) {
  std::vector<double> warming;
  for (int i = 0; i < 500; ++i) warming.push_back(0.1 * i);
  const auto loop = loop_over(warming, residual_of(warming, 0, 1, no_shape), kBins);
  EXPECT_EQ(loop.widest(), nullptr);
  EXPECT_FALSE(loop.test.structured());
}

}  // namespace
}  // namespace fogcomp::compare
