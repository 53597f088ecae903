#include <gtest/gtest.h>

#include <cmath>

#include "network/trainer_parts.hpp"
#include "research/anfis.hpp"
#include "research/comparator.hpp"
#include "research/polynomial.hpp"
#include "research/support_vectors.hpp"
#include "support/input_error.hpp"

namespace fogcomp::research {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Rows {
  MatrixXd inputs;
  VectorXd target;
};

// A surface over temperature and rate such as a gyro has, with uniform noise of +-`noise`.
Rows gyro_like(Index rows, double noise, std::uint64_t seed) {
  network::Uniform uniform(seed);
  Rows result{MatrixXd(rows, 2), VectorXd(rows)};
  for (Index i = 0; i < rows; ++i) {
    const double t = 10 + uniform.within(50);
    const double rate = uniform.within(0.5);
    result.inputs.row(i) << t, rate;
    result.target[i] = 0.7 - 3e-5 * t * t + 0.14 * rate - 1e-3 * t * rate + 0.02 * std::sin(t / 8) +
                       uniform.within(noise);
  }
  return result;
}

double rms(const VectorXd& values) {
  return values.norm() / std::sqrt(static_cast<double>(values.size()));
}

TEST(Polynomial, ReproducesAPolynomialInAnyNumberOfVariables) {
  const MatrixXd inputs = gyro_like(200, 0, 1).inputs;
  const VectorXd t = inputs.col(0);
  const VectorXd r = inputs.col(1);
  const VectorXd target =
      (1 + 0.1 * t.array() - 0.002 * t.array().square() * r.array() + 3 * r.array().cube());
  const Polynomial fitted(inputs, target, 3);
  EXPECT_LT((fitted.values(inputs) - target).cwiseAbs().maxCoeff(), 1e-10);
  const Polynomial too_low(inputs, target, 2);
  EXPECT_GT((too_low.values(inputs) - target).cwiseAbs().maxCoeff(), 0.01);
}

TEST(Polynomial, CrossValidationFindsTheOrder) {
  network::Uniform uniform(2);
  MatrixXd t(1000, 1);
  VectorXd target(1000);
  for (Index i = 0; i < 1000; ++i) {
    t(i, 0) = -40 + 0.1 * static_cast<double>(i);
    const double x = (t(i, 0) - 10) / 50;
    target[i] = x * x * x * x - x * x + uniform.within(0.1);
  }
  const int order = Polynomial::best_order(t, target);
  EXPECT_GE(order, 4);
  EXPECT_LE(order, 6);
}

TEST(CrossValidation, JudgesOnRowsThatWereLeftOut) {
  const Rows rows = gyro_like(500, 0.1, 3);
  // Stores every row it was fitted to and predicts nothing for others.
  const double memory = cross_validated_rms(
      rows.inputs, rows.target, [](const MatrixXd& train, const VectorXd& y, const MatrixXd& test) {
        VectorXd values = VectorXd::Zero(test.rows());
        for (Index i = 0; i < test.rows(); ++i) {
          for (Index j = 0; j < train.rows(); ++j) {
            if (test.row(i) == train.row(j)) values[i] = y[j];
          }
        }
        return values;
      });
  EXPECT_NEAR(memory, rms(rows.target), 1e-12);
}

TEST(SupportVectors, LearnASurfaceAndNotItsNoise) {
  const Rows rows = gyro_like(1500, 0.02, 4);
  const Rows fresh = gyro_like(500, 0, 5);
  const SupportVectors machine(rows.inputs, rows.target, 0.4, 1e-6);
  EXPECT_LT(rms(machine.values(fresh.inputs) - fresh.target), 0.004);
  // With a high price of curvature the function is flat: the mean of the target.
  const SupportVectors flat(rows.inputs, rows.target, 0.4, 1e6);
  EXPECT_NEAR(rms(flat.values(fresh.inputs).array() - rows.target.mean()), 0, 1e-4);
}

TEST(Anfis, LearnsASurfaceBetterThanItsStraightLinesAlone) {
  const Rows rows = gyro_like(1500, 0.005, 6);
  const Rows fresh = gyro_like(500, 0, 7);
  const Anfis first(rows.inputs, rows.target, 1);
  const Anfis trained(rows.inputs, rows.target, 60);
  EXPECT_LT(trained.mean_square(), 0.8 * first.mean_square());
  EXPECT_LT(rms(trained.values(fresh.inputs) - fresh.target), 0.01);
}

TEST(Anfis, StaysFiniteFarOutside) {
  const Rows rows = gyro_like(300, 0.005, 8);
  const Anfis anfis(rows.inputs, rows.target, 5);
  const MatrixXd far = MatrixXd::Constant(1, 2, 1e6);
  EXPECT_LT(std::abs(anfis.values(far)[0]), 10);
}

TEST(Comparators, HaveNamesThatCanBeFound) {
  for (const ComparatorEntry& entry : comparators()) {
    EXPECT_EQ(&find_comparator(entry.name), &entry);
  }
  EXPECT_THROW(find_comparator("random-forest"), InputError);
}

}  // namespace
}  // namespace fogcomp::research
