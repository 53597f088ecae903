#pragma once

#include <string>
#include <vector>

#include "model/effect_list.hpp"
#include "planning/information.hpp"
#include "series/block_series.hpp"

namespace fogcomp::planning {

/// What a recording is good for.
struct Prospect {
  /// The model to begin with, in the syntax of model::parse_effects(): a quadratic of the
  /// temperature and its rate, a cubic, or a cubic and the rate. It is expected to err least in the
  /// box of the recording: all its temperatures, at its fastest ramps in both senses. Of models
  /// that the recording does not tell apart, as where a gyro warms itself up, it is the one whose
  /// error is small even if another is right.
  std::string first_effects = model::kFirstEffects;
  /// From which size on it shows each effect beside these.
  std::vector<VisibleSize> visible;
};

/// `row_s`, `derivative_tau_s`: of the fit. The recording has rows that count.
Prospect prospect_of(const series::BlockSeries& recording, double row_s, double derivative_tau_s);

}  // namespace fogcomp::planning
