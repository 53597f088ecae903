#pragma once

#include <Eigen/Core>
#include <vector>

namespace fogcomp {

/// Inner products of all columns of the parts, side by side and of as many rows each: for hundreds
/// of columns; decompositions.hpp has it for few. The same bits on every processor.
Eigen::MatrixXd gram(const std::vector<Eigen::MatrixXd>& parts);

}  // namespace fogcomp
