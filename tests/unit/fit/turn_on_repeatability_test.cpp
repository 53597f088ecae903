#include "fit/turn_on_repeatability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/decompositions.hpp"
#include "unit/fit/runs_apart.hpp"

namespace fogcomp::fit {
namespace {

using fog::test::chance_of_slope;
using fog::test::runs_apart;

constexpr Eigen::Index kPowerOns = 8;
constexpr Eigen::Index kRowsOfEach = 20;
constexpr Eigen::Index kAllRows = kPowerOns * kRowsOfEach;
constexpr Eigen::Index kTerms = 3;  // bias, and a polynomial of degree 2

Eigen::MatrixXd ones_of_power_ons() {
  Eigen::MatrixXd ones = Eigen::MatrixXd::Zero(kAllRows, kPowerOns);
  for (Eigen::Index i = 0; i < kPowerOns; ++i)
    ones.col(i).segment(i * kRowsOfEach, kRowsOfEach).setOnes();
  return ones;
}

// Power-ons at one temperature each, which varies by `within` of a step between them.
Eigen::MatrixXd terms_of(double within) {
  Eigen::MatrixXd terms(kAllRows, kTerms);
  for (Eigen::Index row = 0; row < kAllRows; ++row) {
    const auto level = static_cast<double>((row / kRowsOfEach) % (kPowerOns / 2));
    const double x =
        level + within * static_cast<double>(row % kRowsOfEach) / kRowsOfEach - kPowerOns / 4.0;
    terms.row(row) << 1, x, x * x;
  }
  return terms;
}

// Least squares with free offsets, for white noise of variance 1.
NoiseWeightedFit free_fit(const Eigen::MatrixXd& terms, const Eigen::VectorXd& measured) {
  NoiseWeightedFit fit;
  fit.columns.resize(kAllRows, kTerms + kPowerOns - 1);
  fit.columns << terms, ones_of_power_ons().rightCols(kPowerOns - 1);
  fit.whitened = fit.columns;
  fit.whitened_measured = measured;
  fit.covariance = inverse_of_definite(gram(fit.columns));
  fit.coefficients = fit.covariance * (fit.columns.transpose() * measured);
  fit.residual_dph = measured - fit.columns * fit.coefficients;
  fit.whitened_residual = fit.residual_dph;
  fit.row_weights = Eigen::VectorXd::Ones(kAllRows);
  return fit;
}

const BiasColumns kColumns{
    0, {kTerms, kPowerOns - 1}, Eigen::VectorXd::Constant(kPowerOns, 1.0 / kPowerOns)};

// Several draws, of which each has its own error.
TEST(TurnOnRepeatability, IsThatOfThePowerOnsAndNoneOfEqualOnes) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  constexpr int kDraws = 60;
  for (const double within : {0.0, 0.1, 3.0}) {
    const Eigen::MatrixXd terms = terms_of(within);
    for (const double repeatability_dph : {0.0, 1.0, 5.0}) {
      double sum = 0;
      int certain = 0;
      for (int draw = 0; draw < kDraws; ++draw) {
        Eigen::VectorXd measured = terms * Eigen::Vector3d(5, -2, 0.3);
        for (double& value : measured) value += normal(random);
        for (Eigen::Index i = 0; i < kPowerOns; ++i)
          measured += repeatability_dph * normal(random) * ones_of_power_ons().col(i);
        const TurnOnRepeatability found =
            turn_on_repeatability(free_fit(terms, measured), kColumns.offsets, {});
        sum += found.dph * found.dph;
        certain += found.chance < 0.01 ? 1 : 0;
      }
      // The noise of a power-on's mean is 0.22.
      EXPECT_NEAR(std::sqrt(sum / kDraws), repeatability_dph, 0.15 + 0.2 * repeatability_dph)
          << within;
      EXPECT_TRUE(repeatability_dph != 0 || certain <= 3) << within << ' ' << certain;
      EXPECT_TRUE(repeatability_dph != 5 || certain >= kDraws - 3) << within << ' ' << certain;
    }
  }
}

TEST(TurnOnRepeatability, OfADriftBetweenRecordings_TellsIt) {
  const std::vector<double> biases_dph{0.1, -0.1, 0.1, 0, -0.1};
  EXPECT_LT(chance_of_slope(runs_apart(biases_dph, 0.02, 1e-4)), 0.01);
  // Each sees the slope, and a bias is no drift within a recording.
  EXPECT_EQ(chance_of_slope(runs_apart(biases_dph, 0.02, 1)), 0);
  // Two recordings leave none to judge it.
  EXPECT_EQ(chance_of_slope(runs_apart({0.1, -0.1}, 0.02, 1e-4)), 1);
}

// Against generalised least squares with the covariance I + spread^2 Z Z' of the rows.
TEST(TurnOnRepeatability, MakesOfFreeOffsetsWhatGeneralisedLeastSquaresFinds) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  const Eigen::MatrixXd ones = ones_of_power_ons();
  for (const double within : {0.1, 0.5, 3.0}) {
    const Eigen::MatrixXd terms = terms_of(within);
    Eigen::VectorXd measured = terms * Eigen::Vector3d(5, -2, 0.3);
    for (Eigen::Index i = 0; i < kPowerOns; ++i) measured += 0.7 * normal(random) * ones.col(i);
    for (double& value : measured) value += normal(random);
    for (const double spread : {0.05, 0.7, 20.0}) {
      const Eigen::MatrixXd inverse =
          inverse_of_definite(Eigen::MatrixXd::Identity(kAllRows, kAllRows) +
                              spread * spread * ones * ones.transpose());
      const Eigen::MatrixXd covariance = inverse_of_definite(terms.transpose() * inverse * terms);
      const Eigen::VectorXd expected = covariance * (terms.transpose() * (inverse * measured));

      NoiseWeightedFit fit = free_fit(terms, measured);
      fit.whitened_residual.setZero();  // a misfit of 1, so that both covariances are alike
      Eigen::MatrixXd of_coefficients = fit.covariance;
      expect_repeatability(spread, kColumns, fit, of_coefficients);
      Eigen::VectorXd found = fit.coefficients.head(kTerms);
      found[0] += fit.coefficients.tail(kPowerOns - 1).sum() / kPowerOns;
      for (Eigen::Index i = 0; i < kTerms; ++i) {
        const double sigma = std::sqrt(covariance(i, i));
        EXPECT_NEAR(found[i], expected[i], 1e-6 * sigma) << i << ", " << within << ", " << spread;
        EXPECT_NEAR(std::sqrt(of_coefficients(i, i)), sigma, 1e-6 * sigma)
            << i << ", " << within << ", " << spread;
        const double of_biases = i == 0 ? spread * spread / kPowerOns : 0;
        EXPECT_NEAR(fit.covariance(i, i) + of_biases, sigma * sigma, 1e-6 * sigma * sigma);
      }
      EXPECT_NEAR((measured - fit.columns * fit.coefficients - fit.residual_dph).norm(), 0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace fogcomp::fit
