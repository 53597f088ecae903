#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "judge/prediction.hpp"
#include "support/random.hpp"
#include "support/statistics.hpp"
#include "support/units.hpp"

namespace {

using fogcomp::Random;
using fogcomp::judge::Prediction;
using fogcomp::judge::Rows;

constexpr Eigen::Index kRows = 500;
constexpr Eigen::Index kUnknowns = 4;  // bias, two effects, a shape
constexpr int kRankedGyros = 400;

struct Drawn {
  Rows rows;
  Eigen::VectorXd truth;
};

// Everything is drawn: two power-ons, coefficients, the shape from its prior, levels of noise.
Drawn draw(std::uint64_t seed) {
  Random random(seed, "gyro");
  Drawn drawn;
  Rows& rows = drawn.rows;
  rows.row_s = 10;
  rows.columns.resize(kRows, kUnknowns);
  rows.prior_sigma = Eigen::VectorXd::Zero(kUnknowns);
  rows.prior_sigma[3] = 0.29;
  rows.first_found = kUnknowns;
  rows.weights = Eigen::VectorXd::Ones(kRows);
  rows.stretches = {{0, 250}, {250, kRows}};
  rows.power_ons = rows.stretches;
  const double cycles = 1.5 + 2 * random.uniform();
  drawn.truth.resize(kUnknowns);
  drawn.truth << random.gaussian(), random.gaussian(), random.gaussian(), 0.29 * random.gaussian();
  const double step = 0.4 * random.uniform();
  const double turn_on = 2 * random.uniform();
  rows.drift_dph.resize(kRows);
  double walk = 0;
  double bias = 0;
  for (Eigen::Index i = 0; i < kRows; ++i) {
    if (i % 250 == 0) {
      walk = 0;
      bias = turn_on * random.gaussian();
    }
    const double phase = 2 * fogcomp::kPi * cycles * static_cast<double>(i) / kRows;
    rows.columns.row(i) << 1, std::sin(phase), std::cos(2 * phase), std::sin(3 * phase);
    walk += step * random.gaussian();
    rows.drift_dph[i] = rows.columns.row(i).dot(drawn.truth) + bias + walk + random.gaussian();
  }
  return drawn;
}

// Simulation-based calibration (Talts et al. 2018): among draws of what is predicted, the truth has
// every rank equally often.
TEST(Prediction, Truths_AmongWhatIsPredicted_HaveEqualRanks) {
  constexpr int kBins = 10;
  std::vector<std::array<int, kBins>> counts(kUnknowns);
  for (int gyro = 0; gyro < kRankedGyros; ++gyro) {
    const Drawn drawn = draw(static_cast<std::uint64_t>(gyro) + 1);
    const Prediction prediction(drawn.rows);
    for (Eigen::Index i = 0; i < kUnknowns; ++i) {
      const double error =
          (drawn.truth[i] - prediction.mean()[i]) / std::sqrt(prediction.covariance()(i, i));
      const double rank = std::erfc(-error / std::sqrt(2.0)) / 2;
      ++counts[static_cast<std::size_t>(i)]
              [static_cast<std::size_t>(std::min(rank * kBins, kBins - 1.0))];
    }
  }
  for (Eigen::Index i = 1; i < kUnknowns; ++i) {
    double square = 0;
    for (const int count : counts[static_cast<std::size_t>(i)]) {
      square += std::pow(count - kRankedGyros / kBins, 2) / (kRankedGyros / kBins);
    }
    std::printf("unknown %d: chi^2 of ranks %.1f of %d\n", static_cast<int>(i), square, kBins - 1);
    EXPECT_LT(square, 27.9) << "unknown " << i;  // chance 0.001
  }
}

}  // namespace
