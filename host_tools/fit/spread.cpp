#include "fit/spread.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "support/decompositions.hpp"
#include "support/statistics.hpp"

namespace fogcomp::fit {
namespace {

// What the rows do not determine has a large variance.
Eigen::MatrixXd covariance_of(const Seen& seen) {
  constexpr double kMinEigenvalue = 1e-12;  // of the correlations
  constexpr double kMinInformation = 1e-300;
  const Eigen::VectorXd unit =
      seen.information.diagonal().cwiseMax(kMinInformation).cwiseSqrt().cwiseInverse();
  const SymmetricEigen axes =
      symmetric_eigen(unit.asDiagonal() * seen.information * unit.asDiagonal());
  const Eigen::MatrixXd scaled = unit.asDiagonal() * axes.vectors;
  return scaled * axes.values.cwiseMax(kMinEigenvalue).cwiseInverse().asDiagonal() *
         scaled.transpose();
}

RobustSpread start_of(const std::vector<Seen>& gyros) {
  std::vector<Eigen::VectorXd> values;
  std::vector<Eigen::VectorXd> sigmas;
  for (const Seen& seen : gyros) {
    const Eigen::MatrixXd covariance = covariance_of(seen);
    values.emplace_back(covariance * seen.towards);
    sigmas.emplace_back(covariance.diagonal().cwiseSqrt());
  }
  return robust_spread(values, sigmas);
}

// In units of the start, so that all unknowns are of one size.
class Maximisation {
 public:
  explicit Maximisation(const std::vector<Seen>& gyros) {
    const RobustSpread start = start_of(gyros);
    unit_ = start.sigma;
    for (const Seen& seen : gyros) {
      gyros_.push_back({unit_.asDiagonal() * seen.information * unit_.asDiagonal(),
                        unit_.cwiseProduct(seen.towards)});
    }
    mean_ = start.median.cwiseQuotient(unit_);
    covariance_ = Eigen::MatrixXd::Identity(unit_.size(), unit_.size());
    find();
  }

  Spread result() const {
    Spread spread;
    spread.mean = unit_.cwiseProduct(mean_);
    spread.mean_covariance = unit_.asDiagonal() * mean_covariance_ * unit_.asDiagonal();
    spread.covariance = unit_.asDiagonal() * covariance_ * unit_.asDiagonal();
    // Fisher's information of a variance: half the sum of the squares of the gyros' weights.
    spread.variance_sigma =
        unit_.cwiseAbs2().cwiseProduct((squared_weights_ / 2).cwiseSqrt().cwiseInverse());
    return spread;
  }

 private:
  Seen from_mean(const Seen& seen) const {
    return {seen.information, seen.towards - seen.information * mean_};
  }

  void find() {
    constexpr int kMaxSteps = 1000;
    constexpr int kStepsPerSearch = 10;  // for departures
    constexpr double kSettled = 1e-5;
    std::vector<Eigen::VectorXd> wider;
    for (int step = 0; step < kMaxSteps; ++step) {
      if (step % kStepsPerSearch == 0) {
        wider.clear();
        for (const Seen& seen : gyros_) wider.push_back(certain_widening(from_mean(seen)));
      }
      const Eigen::VectorXd before = covariance_.diagonal();
      maximise(wider);
      const Eigen::ArrayXd change = covariance_.diagonal().array() / before.array() - 1;
      if (step > kStepsPerSearch && change.abs().maxCoeff() < kSettled) return;
    }
  }

  // Only of certain departures: else the largest of normal values would count less.
  Eigen::VectorXd certain_widening(const Seen& seen) const {
    Eigen::VectorXd wider = widening(covariance_, seen);
    const std::vector<Departure> found = departures(covariance_, seen, wider);
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (!found[i].is_certain()) wider[static_cast<Eigen::Index>(i)] = 1;
    }
    return wider;
  }

  void maximise(const std::vector<Eigen::VectorXd>& wider) {
    const Eigen::Index size = mean_.size();
    Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(size, size);
    Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(size);
    squared_weights_ = Eigen::VectorXd::Zero(size);
    for (std::size_t i = 0; i < gyros_.size(); ++i) {
      // weight: inverse of the gyro's covariance and its rows' together, also if these know nothing
      const auto& [information, towards] = gyros_[i];
      const Eigen::PartialPivLU<Eigen::MatrixXd> solved(Eigen::MatrixXd::Identity(size, size) +
                                                        information *
                                                            with_departures(covariance_, wider[i]));
      const Eigen::MatrixXd weight = solved.solve(information);
      const Eigen::VectorXd own =
          covariance_ * solved.solve(Eigen::VectorXd(towards - information * mean_));
      const Eigen::MatrixXd known = covariance_ * weight * covariance_;
      squares += own * own.transpose() + covariance_ - known;
      weights += weight;
      sum += solved.solve(towards);
      squared_weights_ +=
          known.diagonal().cwiseQuotient(covariance_.diagonal().cwiseAbs2()).cwiseAbs2();
    }
    // Of few gyros correlations are shrunk: as if `size` + 1 more had none.
    const auto count = static_cast<double>(gyros_.size());
    const Eigen::VectorXd variances = squares.diagonal() / count;
    covariance_ = squares / (count + static_cast<double>(size) + 1);
    covariance_.diagonal() = variances;
    const Eigen::LDLT<Eigen::MatrixXd> all(weights);
    mean_covariance_ = all.solve(Eigen::MatrixXd::Identity(size, size));
    mean_ = all.solve(sum);
  }

  Eigen::VectorXd unit_;
  std::vector<Seen> gyros_;
  Eigen::VectorXd mean_;
  Eigen::MatrixXd mean_covariance_;
  Eigen::MatrixXd covariance_;
  Eigen::VectorXd squared_weights_;  // sums, of each unknown's own variance
};

}  // namespace

Eigen::MatrixXd Spread::of_next_gyro() const {
  Eigen::MatrixXd all = covariance + mean_covariance;
  all.diagonal() += variance_sigma;
  return all;
}

Spread spread_of(const std::vector<Seen>& gyros) {
  return Maximisation(gyros).result();
}

RobustSpread robust_spread(const std::vector<Eigen::VectorXd>& values,
                           const std::vector<Eigen::VectorXd>& sigmas) {
  const Eigen::Index size = values.front().size();
  RobustSpread spread{Eigen::VectorXd(size), Eigen::VectorXd(size)};
  for (Eigen::Index i = 0; i < size; ++i) {
    std::vector<double> own;
    std::vector<double> uncertain;
    for (std::size_t gyro = 0; gyro < values.size(); ++gyro) {
      own.push_back(values[gyro][i]);
      uncertain.push_back(sigmas[gyro][i]);
    }
    spread.median[i] = median(own);
    for (double& value : own) value -= spread.median[i];
    spread.sigma[i] = std::max(sigma_by_median(own), median(uncertain));
  }
  return spread;
}

}  // namespace fogcomp::fit
