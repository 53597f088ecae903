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

/// Column range of each term's regressors in the matrix of all terms. `block_s`: block length of
/// the effects; does not change the number of columns.
std::vector<ColumnRange> columns_of(const std::vector<model::EffectTerm>& terms, double block_s);

}  // namespace fogcomp::series
