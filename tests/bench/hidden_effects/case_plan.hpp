#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cycles.hpp"
#include "gyro_draw.hpp"
#include "hidden_draw.hpp"

namespace fogcomp::bench {

/// A recording to be made.
struct PlannedRun {
  std::string name;  ///< run1, run2, run3, unseen
  std::string programme;
  std::uint64_t seed;
};

/// A gyro, its hidden effects, and its recordings.
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
  int drawn = 0;         ///< number of draws until a gyro suited
  bool loop = false;     ///< also run `diagnose --max-effects`

  /// `--effect` options with the hidden effects at `values`.
  std::vector<std::string> effect_options() const;
  /// Arguments of `fogcomp simulate` for a run, without files, separated by blanks.
  std::string arguments(const PlannedRun& run) const;
};

/// Draws the case; trial simulations determine the sizes. A gyro is drawn again if
///  - the effect is almost invisible: the declared model leaves less than 5 % of it, or the
///    programmes do not excite it;
///  - the catalogue's formula, with its best shape, explains less than 85 % of the visible part of
///  a
///    catalogued effect, so that its name is not clearly the right answer;
///  - one of a pair alone lowers the error by a tenth or more;
///  - the formulas do not describe the declared effects, simulated as physics, even with a delay
///  each:
///    that would be a second hidden effect, or a clean run that is not clean.
CasePlan plan_case(const CaseId& id);

}  // namespace fogcomp::bench
