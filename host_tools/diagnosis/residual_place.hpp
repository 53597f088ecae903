#pragma once

#include <string>
#include <vector>

#include "diagnosis/diagnosis_data.hpp"
#include "diagnosis/structure.hpp"

namespace fogcomp::diagnosis {

struct NamedShare {
  std::string name;
  double share = 0;
};

/// The variables on which a residual depends and its segments, from the part that smooth functions
/// describe.
struct ResidualPlace {
  std::string variable;               ///< on which it depends most; "" if on none
  std::vector<NamedShare> variables;  ///< evidence of each alone; the best is 1
  std::vector<NamedShare> segments;   ///< where in the runs it sits; sums to 1
};

/// `residual`: whitened like `structure`.
ResidualPlace place_of(const VisibleStructure& structure, const Eigen::VectorXd& residual,
                       const std::vector<recording::Segment>& segments);

}  // namespace fogcomp::diagnosis
