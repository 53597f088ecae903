#pragma once

#include <string>
#include <vector>

namespace fogcomp::recording {

/// A time in a run at which the gyro's bias begins anew: a mode hop, a stick-slip, a shock. What
/// depends on temperature, time or another input goes on.
struct Cut {
  std::string run{};  ///< path or name of its file; "": all files
  double at_s = 0;    ///< since power-on
};

/// Reads `T` or `RUN:T`, seconds. Throws InputError for anything else.
Cut parse_cut(const std::string& text);

/// As parse_cut() reads it.
std::string cut_text(const Cut& cut);

/// Throws InputError for a cut whose file is not among `runs`.
void require_cut_runs(const std::vector<Cut>& cuts, const std::vector<std::string>& runs);

}  // namespace fogcomp::recording
