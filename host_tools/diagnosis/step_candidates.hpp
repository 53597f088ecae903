#pragma once

#include <vector>

#include "diagnosis/candidates.hpp"
#include "diagnosis/structure.hpp"

namespace fogcomp::diagnosis {

/// Shapes of an event: steps at evenly spaced times of each recording at which they are visible.
std::vector<Candidate::Shape> step_shapes(const ShapeSpace& space, const model::EffectTerm& step);

/// The steps, a few of them moved from their grid times to rows, at least half a grid interval
/// apart: to those at which a step explains most of what the model leaves
/// (rules::kMinMovedChi2Drop), and to those at which the residual jumps, a step explaining most of
/// what the `smooth` functions (orthonormal, as visible_structure() makes them) leave as well, in
/// units of its mean square (rules::kMinPlacedChi2Drop): an effect that is missing, too, has no
/// edges. Other steps are tested on the grid only, as noise is.
std::vector<Candidate::Shape> placed_steps(std::vector<Candidate::Shape> shapes,
                                           const ShapeSpace& space,
                                           const Residualizer& residualizer,
                                           const Eigen::MatrixXf& smooth);

/// Without steps where the residual changes over minutes rather than within a row
/// (noise::gain_of_gradual_change(), kPossibleSigmas): slow noise, or another effect.
/// May leave none.
std::vector<Candidate::Shape> without_gradual_steps(std::vector<Candidate::Shape> shapes,
                                                    const series::Rows& rows,
                                                    const fit::NoiseWeightedFit& fit);

}  // namespace fogcomp::diagnosis
