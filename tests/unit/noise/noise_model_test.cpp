#include "noise/noise_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "noise/whitening.hpp"

namespace fogcomp::noise {
namespace {

using Eigen::VectorXd;

VectorXd noise(std::size_t rows, double white, double slow, double tau_rows, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const double decay = std::exp(-1 / tau_rows);
  double state = slow * normal(random);
  VectorXd values(static_cast<Eigen::Index>(rows));
  for (double& value : values) {
    value = state + white * normal(random);
    state = decay * state + slow * std::sqrt(1 - decay * decay) * normal(random);
  }
  return values;
}

// Spectral density at an angle per row, on which the weighting depends; its division among the
// components does not matter.
double density(const NoiseModel& model, double angle) {
  double sum = model.white_variance;
  for (const auto& component : model.components) {
    const double phi = std::exp(-model.row_s / component.tau_s);
    sum += component.variance * (1 - phi * phi) / (1 - 2 * phi * std::cos(angle) + phi * phi);
  }
  return sum;
}

TEST(NoiseModel, HasTheSpectrumOfWhiteAndSlowNoiseWithin20Percent) {
  std::vector<VectorXd> quiet;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) quiet.push_back(noise(700, 0.02, 0.01, 30, seed));
  const auto model = fit_noise(noise_samples(quiet), 10, 0);
  NoiseModel truth;
  truth.row_s = 10;
  truth.white_variance = 0.02 * 0.02;
  truth.components = {{300, 0.01 * 0.01}};
  for (const double angle : {3.0, 1.0, 0.3, 0.1}) {
    EXPECT_NEAR(density(model, angle) / density(truth, angle), 1, 0.2) << angle;
  }
  EXPECT_NEAR(density(model, 0.03) / density(truth, 0.03), 1, 0.35);
}

TEST(NoiseModel, FindsNoSlowPartInWhiteNoise) {
  std::vector<VectorXd> quiet;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) quiet.push_back(noise(700, 0.02, 0, 30, seed));
  const auto model = fit_noise(noise_samples(quiet), 10, 0);
  EXPECT_NEAR(std::sqrt(density(model, 0.03)), 0.02, 0.006);
}

// Compared with the true scatter of the density at four periods per run over many gyros. A fit
// states ten and five times as much; hundreds would mean that slow noise counts as known.
TEST(NoiseModel, TakesSlowNoiseOfFewPeriodsForUncertain) {
  constexpr double kRun_s = 28000;
  constexpr int kGyros = 60;
  for (const double tau_rows : {10.0, 60.0}) {
    double sum = 0;
    double squares = 0;
    std::vector<double> degrees_of_freedom;
    for (std::uint64_t gyro = 1; gyro <= kGyros; ++gyro) {
      std::vector<VectorXd> quiet;
      for (std::uint64_t soak = 0; soak < 4; ++soak) {
        quiet.push_back(noise(360, 0.024, 0.02, tau_rows, 4 * gyro + soak));
      }
      const auto model = fit_noise(noise_samples(quiet), 10, kRun_s);
      const double power = density(model, 2 * M_PI * 4 * 10 / kRun_s);
      sum += power;
      squares += power * power;
      degrees_of_freedom.push_back(model.degrees_of_freedom);
    }
    const double mean = sum / kGyros;
    const double scatters_as = 2 * mean * mean / (squares / kGyros - mean * mean);
    std::sort(degrees_of_freedom.begin(), degrees_of_freedom.end());
    EXPECT_LT(degrees_of_freedom[kGyros / 2], 15 * scatters_as) << tau_rows;
    EXPECT_GT(degrees_of_freedom[kGyros / 2], scatters_as) << tau_rows;
  }
}

TEST(NoiseModel, WithoutQuietPartsTakesNeighbouringRowsAndNoDriftOrOutlier) {
  VectorXd residual = noise(3000, 0.02, 0, 1, 1);
  for (Eigen::Index i = 0; i < residual.size(); ++i)
    residual[i] += 1e-6 * std::pow(static_cast<double>(i), 2);
  residual[100] += 50;
  EXPECT_NEAR(white_noise_of(residual, 10, 60000).white_dph(), 0.02, 0.002);
}

TEST(Whitening, MakesColouredNoiseWhiteOfVarianceOneAcrossGapsAndRuns) {
  const std::size_t size = 4000;
  const VectorXd coloured = noise(2 * size, 0.02, 0.03, 50, 3);
  NoiseModel model;
  model.row_s = 10;
  model.white_variance = 0.02 * 0.02;
  model.components = {{500, 0.03 * 0.03}};
  // Every third of some rows is missing.
  series::Rows rows;
  std::vector<double> kept;
  for (std::size_t i = 0; i < 2 * size; ++i) {
    if (i > 1000 && i < 3000 && i % 3 == 0) continue;
    rows.time_s.push_back(10 * static_cast<double>(i));
    kept.push_back(coloured[static_cast<Eigen::Index>(i)]);
  }
  rows.drift_dph = Eigen::Map<VectorXd>(kept.data(), static_cast<Eigen::Index>(kept.size()));
  rows.run_starts = {0};
  const VectorXd ones = VectorXd::Ones(rows.drift_dph.size());
  const VectorXd white = Whitening(model, rows, ones).apply(rows.drift_dph);
  const auto count = static_cast<double>(white.size());
  EXPECT_NEAR(white.squaredNorm() / count, 1, 0.06);
  for (const Eigen::Index lag : {1, 2, 5, 20}) {
    const double correlation =
        white.head(white.size() - lag).dot(white.tail(white.size() - lag)) / count;
    EXPECT_NEAR(correlation, 0, 4 / std::sqrt(count)) << lag;
  }
}

TEST(Whitening, GivesEachOfManyColumnsWhatItGivesItAlone) {
  series::Rows rows;
  for (int i = 0; i < 50; ++i) rows.time_s.push_back(10.0 * i + (i > 20 ? 300 : 0));
  rows.run_starts = {0, 35};
  rows.drift_dph = VectorXd::Zero(50);
  NoiseModel model;
  model.white_variance = 1;
  for (const double tau_s : {30.0, 100.0, 300.0, 1000.0}) {  // one, two, three, four states
    model.components.push_back({tau_s, 0.5});
    const Whitening whitening(model, rows, VectorXd::Ones(50));
    const Eigen::MatrixXd columns = Eigen::MatrixXd::Random(50, 7);  // four, two and one
    const Eigen::MatrixXd white = whitening.apply(columns);
    for (Eigen::Index i = 0; i < columns.cols(); ++i) {
      EXPECT_EQ(white.col(i), whitening.apply(columns.col(i)).col(0)) << i;
    }
    EXPECT_GT((white.col(0) - white.col(6)).norm(), 1);
  }
}

TEST(Whitening, IsTheIdentityOverSigmaForWhiteNoise) {
  series::Rows rows;
  rows.drift_dph = VectorXd::LinSpaced(10, 0, 9);
  for (int i = 0; i < 10; ++i) rows.time_s.push_back(10.0 * i);
  rows.run_starts = {0};
  NoiseModel model;
  model.row_s = 10;
  model.white_variance = 4;
  const VectorXd white = Whitening(model, rows, VectorXd::Ones(10)).apply(rows.drift_dph);
  EXPECT_LE((white - rows.drift_dph / 2).norm(), 1e-12);
}

}  // namespace
}  // namespace fogcomp::noise
