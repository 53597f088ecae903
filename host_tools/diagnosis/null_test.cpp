#include "diagnosis/null_test.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "support/decompositions.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr int kDraws = 400;
constexpr double kTailShare = 0.15;  // of the draws that an exponential tail is fitted to
constexpr double kCovarianceRidge = 1e-7;

// The best effect's evidence, measured in the noise that smooth functions still find beside that
// effect: where slow noise is stronger than the quiet parts said, it is so in every direction.
double best_evidence(const fit::ExplainedSpace& space, const Library& library,
                     const series::ColumnRange& structure, double freedom,
                     const Eigen::VectorXd& along) {
  const auto most = [&](const Eigen::VectorXd& values, series::ColumnRange* where) {
    double evidence = 0;
    for (const std::vector<series::ColumnRange>& shapes : library) {
      const BestShape best = best_shape(space, shapes, {}, values);
      if (best.log_evidence <= evidence) continue;
      evidence = best.log_evidence;
      if (where != nullptr) *where = shapes[best.shape];
    }
    return evidence;
  };
  series::ColumnRange best;
  if (most(along, &best) == 0) return 0;
  const double left = space.gain({best, structure}, along) - space.gain({best}, along);
  const double variance = (freedom + left) / (freedom + static_cast<double>(structure.count));
  return most(along / std::sqrt(std::max(1.0, variance)), nullptr);
}

// Logarithm of the share of draws beyond `value`; beyond the upper draws, by their exponential
// tail.
double beyond_log_p(std::vector<double> draws, double value) {
  std::sort(draws.begin(), draws.end());
  const auto size = static_cast<double>(draws.size());
  const auto above =
      static_cast<double>(draws.end() - std::lower_bound(draws.begin(), draws.end(), value));
  if (above > kTailShare * size) return std::log(above / size);
  const auto start = draws.end() - static_cast<std::ptrdiff_t>(kTailShare * size);
  double mean = 0;
  for (auto draw = start; draw != draws.end(); ++draw) mean += *draw - *start;
  mean = std::max(mean / (kTailShare * size), 1e-6);
  return std::log(kTailShare) - std::max(0.0, value - *start) / mean;
}

}  // namespace

NullTest test_against_noise(const fit::ExplainedSpace& space, const Library& library,
                            const series::ColumnRange& structure, double freedom,
                            std::uint64_t seed) {
  Eigen::MatrixXd covariance = space.gram();
  covariance.diagonal().array() += kCovarianceRidge * covariance.diagonal().maxCoeff();
  const Eigen::MatrixXd root = cholesky_factor(covariance);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::gamma_distribution<double> variance(freedom / 2, 2 / freedom);
  std::vector<double> evidence;
  std::vector<double> smooth;
  Eigen::VectorXd white(covariance.rows());
  for (int draw = 0; draw < kDraws; ++draw) {
    for (double& value : white) value = normal(random);
    white /= std::sqrt(variance(random));
    const Eigen::VectorXd along = root.triangularView<Eigen::Lower>() * white;
    evidence.push_back(best_evidence(space, library, structure, freedom, along));
    smooth.push_back(along.segment(structure.first, structure.count).squaredNorm());
  }
  NullTest test;
  test.library_log_p =
      beyond_log_p(evidence, best_evidence(space, library, structure, freedom, space.along()));
  test.structure_log_p =
      beyond_log_p(smooth, space.along().segment(structure.first, structure.count).squaredNorm());
  return test;
}

}  // namespace fogcomp::diagnosis
