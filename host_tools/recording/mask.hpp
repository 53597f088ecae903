#pragma once

#include <string>
#include <vector>

namespace fogcomp::recording {

/// A stretch of time whose rates count nowhere: not in a fit, nor in what a model is judged by. Its
/// temperatures do: the gyro has gone through them.
struct Mask {
  std::string run{};  ///< path or name of the file that it is for; "": every one
  double from_s = 0;  ///< since power-on, both ends included
  double to_s = 0;

  bool hides(double time_s) const { return time_s >= from_s && time_s <= to_s; }
};

/// Reads `FROM..TO` or `RUN:FROM..TO`, seconds. Throws InputError for anything else.
Mask parse_mask(const std::string& text);

/// Those of `masks` that are for the file at `path`.
std::vector<Mask> masks_of(const std::vector<Mask>& masks, const std::string& path);

/// Throws InputError for a mask of a file that is none of `runs`.
void require_masked_runs(const std::vector<Mask>& masks, const std::vector<std::string>& runs);

}  // namespace fogcomp::recording
