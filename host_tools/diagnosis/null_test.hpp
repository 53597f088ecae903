#pragma once

#include <cstdint>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/hypotheses.hpp"
#include "fit/explained_space.hpp"

namespace fogcomp::diagnosis {

/// Probability that noise alone resembles an effect.
struct NullTest {
  double library_log_p = 0;    ///< of the best effect of the catalogue being this good
  double structure_log_p = 0;  ///< of smooth structure of any kind being this strong

  bool finds_something() const {
    return library_log_p < rules::kLibraryLogP || structure_log_p < rules::kStructureLogP;
  }
};

/// Compares the best of all effects and shapes with its Monte-Carlo null distribution: white noise
/// projected into the same space. `degrees_of_freedom`: of the estimated noise variance.
NullTest test_against_noise(const fit::ExplainedSpace& space, const RegressorBasis& regressors,
                            const series::ColumnRange& structure, double degrees_of_freedom,
                            std::uint64_t seed);

}  // namespace fogcomp::diagnosis
