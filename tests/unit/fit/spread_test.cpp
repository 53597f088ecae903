#include "fit/spread.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fogcomp::fit {
namespace {

const Eigen::Vector2d kMeanOfTwo{3, -1};
constexpr double kSigmaOfTwo = 0.2;  // from gyro to gyro, of both unknowns
constexpr double kRhoOfTwo = 0.8;    // between them

// What the rows of gyros say, which see the sum with this standard deviation, the difference with
// `others`.
std::vector<Seen> gyros_of(std::size_t count, std::uint64_t seed, double of_sum, double others) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Eigen::Matrix2d axes;
  axes << 1, 1, 1, -1;
  axes /= std::sqrt(2.0);
  const Eigen::Matrix2d information =
      axes * Eigen::Vector2d(std::pow(of_sum, -2), std::pow(others, -2)).asDiagonal() * axes;
  std::vector<Seen> gyros;
  for (std::size_t i = 0; i < count; ++i) {
    const double first = normal(random);
    const double second = kRhoOfTwo * first + std::sqrt(1 - kRhoOfTwo * kRhoOfTwo) * normal(random);
    const Eigen::Vector2d error(of_sum * normal(random), others * normal(random));
    const Eigen::Vector2d values =
        kMeanOfTwo + kSigmaOfTwo * Eigen::Vector2d(first, second) + axes * error;
    gyros.push_back({information, information * values});
  }
  return gyros;
}

TEST(Spread, IsThatOfTheGyrosWithoutTheirRowsOwnErrors) {
  const Spread found = spread_of(gyros_of(200, 1, 0.1, 0.4));
  for (Eigen::Index i = 0; i < 2; ++i) {
    EXPECT_NEAR(found.mean[i], kMeanOfTwo[i], 4 * std::sqrt(found.mean_covariance(i, i)));
    EXPECT_NEAR(found.covariance(i, i), kSigmaOfTwo * kSigmaOfTwo, 4 * found.variance_sigma[i]);
    EXPECT_LT(found.variance_sigma[i], kSigmaOfTwo * kSigmaOfTwo / 2);
  }
  EXPECT_NEAR(found.covariance(0, 1), kRhoOfTwo * kSigmaOfTwo * kSigmaOfTwo,
              0.3 * kSigmaOfTwo * kSigmaOfTwo);
}

// The share of lots whose further gyro lies within one, and within two, standard deviations.
TEST(Spread, OfASmallLotPromisesWhatAFurtherGyroHolds) {
  constexpr int kLots = 80;
  int within_one = 0;
  int within_two = 0;
  for (int seed = 0; seed < kLots; ++seed) {
    const Spread found = spread_of(gyros_of(15, static_cast<std::uint64_t>(seed), 0.02, 0.3));
    std::mt19937_64 random(static_cast<std::uint64_t>(seed) + 10'000);
    const double next = kMeanOfTwo[0] + kSigmaOfTwo * std::normal_distribution<double>()(random);
    const double sigma = std::sqrt(found.of_next_gyro()(0, 0));
    within_one += std::abs(next - found.mean[0]) < sigma ? 1 : 0;
    within_two += std::abs(next - found.mean[0]) < 2 * sigma ? 1 : 0;
  }
  EXPECT_GT(within_one, 0.65 * kLots);
  EXPECT_LT(within_one, 0.85 * kLots);
  EXPECT_GT(within_two, 0.94 * kLots);
}

TEST(Spread, OfWhatNoGyroShowsWellStaysWide) {
  const Spread found = spread_of(gyros_of(15, 1, 0.02, 3));
  const Eigen::Vector2d difference = Eigen::Vector2d(1, -1) / std::sqrt(2.0);
  const double variance = difference.dot(found.of_next_gyro() * difference);
  EXPECT_GT(variance, std::pow(3, 2) / 15);
}

TEST(Spread, IsNotWidenedByAGyroThatDeparts) {
  std::vector<Seen> gyros = gyros_of(15, 2, 0.02, 0.02);
  const Spread before = spread_of(gyros);
  gyros[3].towards =
      gyros[3].information * (kMeanOfTwo + 10 * kSigmaOfTwo * Eigen::Vector2d::UnitX());
  const Spread found = spread_of(gyros);
  EXPECT_LT(found.covariance(0, 0), 1.5 * before.covariance(0, 0));
  EXPECT_NEAR(found.mean[0], before.mean[0], kSigmaOfTwo / 2);
}

TEST(Spread, TakesGyrosThatSayNothingOfAnUnknown) {
  std::vector<Seen> gyros = gyros_of(15, 3, 0.02, 0.02);
  const Spread before = spread_of(gyros);
  for (std::size_t i = 0; i < 3; ++i) {
    gyros[i].information.row(1).setZero();
    gyros[i].information.col(1).setZero();
    gyros[i].towards[1] = 0;
  }
  const Spread found = spread_of(gyros);
  EXPECT_NEAR(found.mean[1], before.mean[1], kSigmaOfTwo / 2);
  EXPECT_NEAR(found.covariance(1, 1), before.covariance(1, 1), 0.5 * before.covariance(1, 1));
}

}  // namespace
}  // namespace fogcomp::fit
