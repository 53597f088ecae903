#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/model.hpp"

namespace fogcomp::series {

/// Consecutive columns of a matrix.
struct ColumnRange {
  Eigen::Index first = 0;
  Eigen::Index count = 0;
};

/// Where each term's regressors stand among those of all, which begin with the first one's.
/// `block_s`: of the effects' steps; it does not change how many there are.
std::vector<ColumnRange> columns_of(const std::vector<model::EffectTerm>& terms, double block_s);

}  // namespace fogcomp::series
