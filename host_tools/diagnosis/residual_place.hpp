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

/// On what a residual depends and where it sits, by what smooth functions can describe of it.
struct ResidualPlace {
  std::string variable;               ///< on which it depends most; "" if on none
  std::vector<NamedShare> variables;  ///< evidence of each alone; the best is 1
  std::vector<NamedShare> segments;   ///< where in the runs it sits; sums to 1
};

/// `residual`: whitened, as `structure`.
ResidualPlace place_of(const VisibleStructure& structure, const Eigen::VectorXd& residual,
                       const std::vector<recording::Segment>& segments);

}  // namespace fogcomp::diagnosis
