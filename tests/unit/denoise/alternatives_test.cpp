// The alternatives to orthogonal wavelets: lifting, and a Kalman smoother with ARMA noise.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "denoise/denoise.hpp"
#include "denoise/kalman_arma.hpp"
#include "denoise/lifting.hpp"

namespace fogcomp::denoise {
namespace {

double rms_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double square = 0;
  for (std::size_t i = 0; i < a.size(); ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(square / static_cast<double>(a.size()));
}

// Soak, ramp with a kink, soak.
std::vector<double> drift(std::size_t size) {
  std::vector<double> values(size);
  for (std::size_t i = 0; i < size; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(size);
    values[i] = t < 0.3 ? 0 : t < 0.7 ? 10 * (t - 0.3) : 4 + std::sin(8 * (t - 0.7));
  }
  return values;
}

std::vector<double> arma_noise(std::size_t size, double phi, double theta) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> values(size);
  double x = 0;
  double last = 0;
  for (double& value : values) {
    const double e = normal(random);
    x = phi * x + e + theta * last;
    last = e;
    value = x;
  }
  return values;
}

TEST(Lifting, IsUndoneForEveryLength) {
  for (std::size_t size = 1; size < 70; ++size) {
    const std::vector<double> values = arma_noise(size, 0, 0);
    std::vector<double> again(size);
    const auto parts = lift({values.data(), size}, 5);
    unlift(parts, {again.data(), size});
    EXPECT_LT(rms_difference(values, again), 1e-14) << size;
  }
}

TEST(Lifting, LeavesNoDetailsOfAStraightLine) {
  std::vector<double> line(64);
  for (std::size_t i = 0; i < line.size(); ++i) line[i] = 3 - 0.25 * static_cast<double>(i);
  const auto parts = lift({line.data(), line.size()}, 1);
  // The last one has no neighbour on its right.
  for (std::size_t i = 0; i + 1 < parts.details[0].size(); ++i) {
    EXPECT_NEAR(parts.details[0][i], 0, 1e-14);
  }
}

TEST(ArmaFit, FindsTheModelThatMadeTheNoise) {
  const std::vector<double> values = arma_noise(20000, 0.6, 0.3);
  const auto noise = fit_arma({values.data(), values.size()});
  EXPECT_NEAR(noise.phi1 + noise.phi2, 0.6, 0.1);  // its running mean takes some away
  EXPECT_NEAR(noise.phi1 + noise.theta, 0.9, 0.1);
  EXPECT_NEAR(noise.variance, 1, 0.05);
}

TEST(ArmaFit, TakesShortRecordingsForWhite) {
  const std::vector<double> values = arma_noise(50, 0.6, 0.3);
  const auto noise = fit_arma({values.data(), values.size()});
  EXPECT_EQ(noise.phi1, 0);
  EXPECT_EQ(noise.theta, 0);
}

class Alternatives : public testing::TestWithParam<DenoiseBy> {};

TEST_P(Alternatives, KeepTheDriftAndRemoveTheNoise) {
  const std::vector<double> truth = drift(4000);
  std::vector<double> values = arma_noise(4000, 0, 0);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = truth[i] + 0.3 * values[i];
  DenoiseMethod method;
  method.by = GetParam();
  denoise({values.data(), values.size()}, method);
  EXPECT_LT(rms_difference(values, truth), 0.1);
}

TEST_P(Alternatives, LeaveAConstantAlone) {
  std::vector<double> values(100, 2.5);
  DenoiseMethod method;
  method.by = GetParam();
  denoise({values.data(), values.size()}, method);
  for (const double value : values) EXPECT_NEAR(value, 2.5, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Denoising, Alternatives,
                         testing::Values(DenoiseBy::lifting, DenoiseBy::kalman));

}  // namespace
}  // namespace fogcomp::denoise
