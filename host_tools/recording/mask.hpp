#pragma once

#include <string>
#include <vector>

namespace fogcomp::recording {

/// An interval of time whose rates are used neither for a fit nor for judging a model. Its
/// temperatures are used, because the gyro experienced them.
struct Mask {
  std::string run{};  ///< path or name of its file; "": all files
  double from_s = 0;  ///< since power-on, both ends included
  double to_s = 0;
};

/// Whether the run of an option, path or name of a file or "" for all, is the file at `path`.
bool names_file(const std::string& run, const std::string& path);

/// Reads `FROM..TO` or `RUN:FROM..TO`, seconds. Throws InputError for anything else.
Mask parse_mask(const std::string& text);

/// The masks for the file at `path`.
std::vector<Mask> masks_of(const std::vector<Mask>& masks, const std::string& path);

/// Whether a mask covers each of these times, which rise.
std::vector<bool> covered(const std::vector<Mask>& masks, const std::vector<double>& time_s);

/// Sum of their lengths.
double length_s(const std::vector<Mask>& masks);

/// Throws InputError for a mask whose file is not among `runs`.
void require_masked_runs(const std::vector<Mask>& masks, const std::vector<std::string>& runs);

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
