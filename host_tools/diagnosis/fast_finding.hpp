#pragma once

#include <cstdint>

#include "diagnosis/evidence_space.hpp"
#include "diagnosis/fast_structure.hpp"
#include "diagnosis/two_levels.hpp"

namespace fogcomp::diagnosis {

/// Structure that no smooth function describes.
enum class FastKind : std::uint8_t { none, line, band, two_levels };

/// Fast structure in the residual of the best explanation and smooth functions.
struct FastFinding {
  FastStructure spectrum;
  TwoLevels jumps;
  FastKind kind = FastKind::none;  ///< the surest, where it is sure
  double log_p = 0;                ///< ln of the chance that noise alone has one as sure
  double excess = 0;               ///< chi^2 above noise that `kind` brings
  Eigen::VectorXd left;            ///< whitened residual of each row in which it is
};

FastFinding find_fast(const EvidenceSpace& evidence, const judge::Explanation& best,
                      const series::SignalSeries& series, const fit::NoiseWeightedFit& fit);

}  // namespace fogcomp::diagnosis
