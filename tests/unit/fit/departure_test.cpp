#include "fit/departure.hpp"

#include <gtest/gtest.h>

namespace fogcomp::fit {
namespace {

// What rows say that see x with this standard deviation in each unknown.
Seen seen(const Eigen::VectorXd& x, double sigma) {
  const Eigen::MatrixXd information =
      Eigen::MatrixXd::Identity(x.size(), x.size()) / (sigma * sigma);
  return {information, information * x};
}

TEST(Widening, LetsGoOfTheUnknownThatTheRowsShowToBeOff) {
  Eigen::MatrixXd covariance(2, 2);
  covariance << 1, 0.5, 0.5, 1;
  const Seen rows = seen(Eigen::Vector2d(5, 0.3), 0.2);
  const Eigen::VectorXd wider = widening(covariance, rows);
  EXPECT_GT(wider[0], 2.5);
  EXPECT_EQ(wider[1], 1);
  const std::vector<Departure> found = departures(covariance, rows, wider);
  EXPECT_TRUE(found[0].is_certain());
  EXPECT_FALSE(found[1].is_certain());
  EXPECT_NEAR(found[0].sigmas, 5, 0.6);
}

TEST(Widening, KeepsThePriorWhereTheRowsCannotTell) {
  const Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(2, 2);
  const Seen rows = seen(Eigen::Vector2d(5, -5), 10);
  EXPECT_EQ(widening(covariance, rows), Eigen::Vector2d::Ones());
}

TEST(Departures, OfWhatTheRowsDoNotMoveAreNone) {
  const Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(2, 2);
  Seen rows = seen(Eigen::Vector2d(1, 0), 0.1);
  rows.information(1, 1) = 0;
  const std::vector<Departure> found = departures(covariance, rows, widening(covariance, rows));
  EXPECT_NEAR(found[0].sigmas, 1, 0.05);
  EXPECT_EQ(found[1].sigmas, 0);
  EXPECT_FALSE(found[1].is_certain());
}

}  // namespace
}  // namespace fogcomp::fit
