#pragma once

#include <cstdint>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/hypotheses.hpp"
#include "fit/explained_space.hpp"

namespace fogcomp::diagnosis {

/// How often noise alone would seem to contain an effect.
struct NullTest {
  double library_log_p = 0;    ///< of the best effect of the catalogue being this good
  double structure_log_p = 0;  ///< of smooth structure of any kind being this strong

  bool finds_something() const {
    return library_log_p < rules::kLibraryLogP || structure_log_p < rules::kStructureLogP;
  }
};

/// The best over all effects and shapes of many draws of white noise, put through the same space.
/// `freedom`: how well the noise itself is known, as the degrees of freedom of a variance.
NullTest test_against_noise(const fit::ExplainedSpace& space, const RegressorBasis& regressors,
                            const series::ColumnRange& structure, double degrees_of_freedom,
                            std::uint64_t seed);

}  // namespace fogcomp::diagnosis
