#include "diagnosis/residual_place.hpp"

#include <cmath>

namespace fogcomp::diagnosis {
namespace {

// Logarithm of the evidence for orthonormal columns against none: noise of unit variance, the most
// probable size (empirical Bayes).
double log_evidence(double chi2_drop, double columns) {
  if (chi2_drop <= columns) return 0;
  return (chi2_drop - columns) / 2 - columns / 2 * std::log(chi2_drop / columns);
}

}  // namespace

ResidualPlace place_of(const VisibleStructure& structure, const Eigen::VectorXd& residual,
                       const std::vector<recording::Segment>& segments) {
  ResidualPlace place;
  double max = 0;
  for (std::size_t i = 0; i < structure.groups.size(); ++i) {
    const Eigen::VectorXd projection = structure.groups[i].cast<double>().transpose() * residual;
    const double evidence =
        log_evidence(projection.squaredNorm(), static_cast<double>(projection.size()));
    place.variables.push_back({structure.variables[i], evidence});
    if (evidence <= max) continue;
    max = evidence;
    place.variable = structure.variables[i];
  }
  for (NamedShare& variable : place.variables) variable.share /= max > 0 ? max : 1;
  const Eigen::MatrixXd all = structure.all.cast<double>();
  const Eigen::VectorXd smooth = all * (all.transpose() * residual);
  double sum = 0;
  for (const recording::Segment& segment : segments) {
    const auto first = static_cast<Eigen::Index>(segment.rows.first);
    const double part =
        smooth.segment(first, static_cast<Eigen::Index>(segment.rows.size())).squaredNorm();
    place.segments.push_back({segment.name, part});
    sum += part;
  }
  for (NamedShare& segment : place.segments) segment.share /= sum > 0 ? sum : 1;
  return place;
}

}  // namespace fogcomp::diagnosis
