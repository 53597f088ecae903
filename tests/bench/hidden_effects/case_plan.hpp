#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cycles.hpp"
#include "gyro_draw.hpp"
#include "hidden_draw.hpp"

namespace fogcomp::bench {

/// One recording to make.
struct PlannedRun {
  std::string name;  ///< run1, run2, run3, unseen
  std::string programme;
  std::uint64_t seed;
};

/// A gyro, what is hidden in it, and the recordings that are made of it.
struct CasePlan {
  CaseKind what;
  DrawnGyro gyro;
  std::vector<HiddenEffect> hidden;
  std::vector<double> values;  ///< of each HiddenEffect::sized
  std::vector<PlannedRun> runs;
  std::optional<PlannedRun> unseen;
  std::string columns;  ///< of simulate --columns
  std::optional<double> latitude_deg;
  double rate_hz = 0.1;  ///< of the recordings
  int drawn = 0;         ///< how often, until a gyro suited
  bool loop = false;     ///< the answer is also asked for by `diagnose --max-effects`

  /// `--effect` options with the hidden effects at `values`.
  std::vector<std::string> effect_options() const;
  /// Arguments of `fogcomp simulate` for a run, without files, blanks between.
  std::string arguments(const PlannedRun& run) const;
};

/// Draws the case; trial simulations find the sizes. Drawn again are gyros on which
/// - the effect is almost invisible: less than 5 % of it is left beside the declared model, or the
///   programmes do not call it up;
/// - the catalogue's formula, with its best shape, explains less than 85 % of what is visible of a
///   catalogued effect, so that its name is not clearly the right answer;
/// - one of a pair alone lowers the error by a tenth or more;
/// - the declared effects themselves, simulated as physics, are not met by their formulas even with
///   a delay each: that would be a second thing hidden, or make a clean run not clean.
CasePlan plan_case(const CaseId& id);

}  // namespace fogcomp::bench
