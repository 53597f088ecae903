#include "recording/dwell_table.hpp"

#include <numeric>

namespace fogcomp::recording {

void become_table(Recording& recording) {
  const double end_s = recording.time_s.back() + kDwellSpacingS;
  for (double& time_s : recording.time_s) time_s -= end_s;
  recording.is_table = true;
  recording.period_s = 0;
  recording.stretch_starts.resize(recording.rows());
  std::iota(recording.stretch_starts.begin(), recording.stretch_starts.end(), 0);
}

}  // namespace fogcomp::recording
