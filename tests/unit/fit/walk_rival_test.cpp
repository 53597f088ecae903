#include "fit/walk_rival.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fit/decision_rules.hpp"
#include "support/units.hpp"
#include "unit/fit/made_rows.hpp"

namespace fogcomp::fit {
namespace {

constexpr std::size_t kRows = 3000;
constexpr double kRow_s = 10;
constexpr double kWhite_dph = 0.02;
constexpr double kWalk = 0.02;  // deg/h/sqrt(h)

// A random walk beside white noise, deg/h.
Eigen::VectorXd walking(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Eigen::VectorXd values(kRows);
  double bias = 0;
  for (double& value : values) {
    bias += kWalk * std::sqrt(kRow_s / 3600) * normal(random);
    value = bias + kWhite_dph * normal(random);
  }
  return values;
}

// Smooth functions of time as flexible as what a diagnosis calls unexplained structure.
Eigen::MatrixXd smooth(Eigen::Index count) {
  Eigen::MatrixXd columns(kRows, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    for (Eigen::Index i = 0; i < columns.rows(); ++i) {
      columns(i, k) = std::cos(kPi * static_cast<double>(k + 1) * (static_cast<double>(i) + 0.5) /
                               static_cast<double>(kRows));
    }
  }
  return columns;
}

noise::NoiseModel white_noise_and_walks() {
  noise::NoiseModel noise;
  noise.row_s = kRow_s;
  noise.white_variance = kWhite_dph * kWhite_dph;
  for (const double ratio : {0.5, 0.7, 1.0, 1.4, 2.0}) noise.walks.push_back({ratio * kWalk, 0});
  return noise;
}

// A bias at one temperature, to which columns are added.
class WalkRivalTest : public testing::Test {
 protected:
  bool refuses_walk(const Eigen::MatrixXd& added, const Eigen::VectorXd& measured) const {
    const Eigen::MatrixXd bias = Eigen::MatrixXd::Ones(kRows, 1);
    return chance_of_walk(rows_, noise_, whitening_,
                          {whitening_.apply(bias), whitening_.apply(added),
                           whitening_.apply(measured)}) < rules::kMaxChanceOfWalk;
  }

 private:
  series::Rows rows_ = fog::test::made_rows(
      kRows, [](double) { return 20.0; }, kRow_s);
  noise::NoiseModel noise_ = white_noise_and_walks();
  noise::Whitening whitening_{noise_, rows_, Eigen::VectorXd::Ones(kRows)};
};

// Smooth functions that describe a walk better than a walk does would be a walk that is taken for a
// missing effect: if its modes end too early, what is beyond them speaks for any smooth function.
TEST_F(WalkRivalTest, IsRarelyRefusedForSmoothFunctions) {
  int refused = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    if (refuses_walk(smooth(40), walking(seed))) ++refused;
  }
  EXPECT_LE(refused, 3);
}

// Three periods of 0.01 deg/h rms beside the walk: with the walk's coefficient estimated as if all
// were a walk, a quarter were accepted.
TEST_F(WalkRivalTest, LetsAnEffectStandBesideAWalk) {
  const auto size = static_cast<Eigen::Index>(kRows);
  const Eigen::VectorXd effect =
      Eigen::VectorXd::LinSpaced(size, 0, 6 * kPi).array().sin() * 0.01 * std::sqrt(2.0);
  int accepted = 0;
  int with_nothing_there = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    if (refuses_walk(effect, walking(seed) + effect)) ++accepted;
    if (refuses_walk(effect, walking(seed))) ++with_nothing_there;
  }
  EXPECT_GE(accepted, 30);
  EXPECT_LE(with_nothing_there, 3);
}

}  // namespace
}  // namespace fogcomp::fit
