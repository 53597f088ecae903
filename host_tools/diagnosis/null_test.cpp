#include "diagnosis/null_test.hpp"

#include <algorithm>
#include <cmath>

#include "support/decompositions.hpp"
#include "support/parallel.hpp"
#include "support/random.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr std::size_t kDraws = 1000;
constexpr std::size_t kTogether = 125;  // draws of one task
constexpr double kTailShare = 0.15;     // share of the draws to which an exponential tail is fitted
constexpr double kCovarianceRidge = 1e-7;

// chi^2 decrease of each candidate alone, for one vector of projections after another.
class SingleCandidateDrops {
 public:
  SingleCandidateDrops(const fit::ExplainedSpace& space, const RegressorBasis& regressors) {
    for (const std::vector<series::ColumnRange>& shapes : regressors) {
      Candidate candidate;
      for (const series::ColumnRange& shape : shapes) {
        candidate.shapes.push_back({shape, space.to_chi2_drop(shape)});
        candidate.columns.push_back(static_cast<double>(shape.count));
      }
      candidate.drops.resize(shapes.size());
      candidates_.push_back(std::move(candidate));
    }
  }

  // Evidence of the best candidate; `where`, if given, is set to its shape.
  double max_evidence(const Eigen::VectorXd& projection, series::ColumnRange* where) {
    double evidence = 0;
    for (Candidate& candidate : candidates_) {
      for (std::size_t i = 0; i < candidate.shapes.size(); ++i) {
        candidate.drops[i] = chi2_drop(candidate.shapes[i], projection);
      }
      const BestShape best = best_of_drops(candidate.drops, candidate.columns);
      if (best.log_evidence <= evidence) continue;
      evidence = best.log_evidence;
      if (where != nullptr) *where = candidate.shapes[best.shape].columns;
    }
    return evidence;
  }

 private:
  struct Shape {
    series::ColumnRange columns;
    Eigen::MatrixXd to_chi2_drop;
  };
  struct Candidate {
    std::vector<Shape> shapes;
    std::vector<double> columns;
    std::vector<double> drops;
  };

  static double chi2_drop(const Shape& shape, const Eigen::VectorXd& projection) {
    double chi2_drop = 0;
    for (Eigen::Index i = 0; i < shape.columns.count; ++i) {
      double part = 0;
      for (Eigen::Index j = 0; j <= i; ++j) {
        part += shape.to_chi2_drop(i, j) * projection[shape.columns.first + j];
      }
      chi2_drop += part * part;
    }
    return chi2_drop;
  }

  std::vector<Candidate> candidates_;
};

// Evidence of the best effect, in units of the noise that smooth functions find beside it: where
// slow noise is stronger than in the quiet parts, it is so in every direction.
double best_evidence(const fit::ExplainedSpace& space, SingleCandidateDrops& drops,
                     const series::ColumnRange& structure, double degrees_of_freedom,
                     const Eigen::VectorXd& projection) {
  series::ColumnRange best;
  if (drops.max_evidence(projection, &best) == 0) return 0;
  const double left =
      space.chi2_drop({best, structure}, projection) - space.chi2_drop({best}, projection);
  const double variance =
      (degrees_of_freedom + left) / (degrees_of_freedom + static_cast<double>(structure.count));
  return drops.max_evidence(projection / std::sqrt(std::max(1.0, variance)), nullptr);
}

// Logarithm of the fraction of draws above `value`; beyond the upper draws, by their exponential
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

NullTest test_against_noise(const fit::ExplainedSpace& space, const RegressorBasis& regressors,
                            const series::ColumnRange& structure, double degrees_of_freedom,
                            std::uint64_t seed) {
  Eigen::MatrixXd covariance = space.gram();
  covariance.diagonal().array() += kCovarianceRidge * covariance.diagonal().maxCoeff();
  const Eigen::MatrixXd root = cholesky_factor(covariance);
  Random random(seed, "noise alone");
  Eigen::MatrixXd white(covariance.rows(), kDraws);
  for (auto draw : white.colwise()) {
    for (double& value : draw) value = random.gaussian();
    draw /= std::sqrt(random.gamma(degrees_of_freedom / 2) * 2 / degrees_of_freedom);
  }
  SingleCandidateDrops drops(space, regressors);
  std::vector<double> evidence(kDraws);
  std::vector<double> smooth(kDraws);
  for_each_index(kDraws / kTogether, [&](std::size_t group) {
    const std::size_t first = group * kTogether;
    const Eigen::MatrixXd draws =
        root.triangularView<Eigen::Lower>() *
        white.middleCols(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(kTogether));
    SingleCandidateDrops own_drops = drops;
    for (std::size_t i = 0; i < kTogether; ++i) {
      const Eigen::VectorXd projection = draws.col(static_cast<Eigen::Index>(i));
      evidence[first + i] =
          best_evidence(space, own_drops, structure, degrees_of_freedom, projection);
      smooth[first + i] = projection.segment(structure.first, structure.count).squaredNorm();
    }
  });
  NullTest test;
  test.library_log_p = beyond_log_p(
      evidence, best_evidence(space, drops, structure, degrees_of_freedom, space.projection()));
  test.structure_log_p = beyond_log_p(
      smooth, space.projection().segment(structure.first, structure.count).squaredNorm());
  return test;
}

}  // namespace fogcomp::diagnosis
