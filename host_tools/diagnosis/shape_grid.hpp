#pragma once

#include <optional>
#include <vector>

#include "diagnosis/candidates.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::diagnosis {

/// Makes shapes of a candidate: columns of an effect beyond those that the model already has.
class ShapeMaker {
 public:
  /// `owned`: number of the effect's first columns that the model has.
  ShapeMaker(const ShapeSpace& space, Eigen::Index owned) : space_(space), owned_(owned) {}

  /// Nothing if the effect is negligible or invisible with these parameters, or an expression is
  /// not finite.
  std::optional<Candidate::Shape> operator()(const model::EffectTerm& term) const;

 private:
  ShapeSpace space_;
  Eigen::Index owned_;
};

/// What a shape adds: rows x 1 or more.
Eigen::MatrixXd columns_of(const Candidate::Shape& shape, const series::SignalSeries& series);
/// Candidate::Shape::basis of a shape, made again.
Eigen::MatrixXf basis_of(const Candidate::Shape& shape, const series::SignalSeries& series,
                         const ProjectOutModel& project_out_model);

/// Mean fraction of a's directions that b explains, 0..1; 1 for the same subspace.
double overlap(const Candidate::Shape& a, const Candidate::Shape& b);

/// All shapes of a term whose marked parameters may vary: a fine grid of the first, coarse grids of
/// the others.
std::vector<Candidate::Shape> all_shapes(const ShapeMaker& make, const model::EffectTerm& term);

}  // namespace fogcomp::diagnosis
