#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fogcomp::batch {

/// Why a gyro is as it is: what a diagnosis of its model on its recordings found.
struct GyroDiagnosis {
  std::string fingerprint;  ///< of the gyro's result, which it belongs to
  std::string verdict;      ///< "none", "missing_effect", "ambiguous", "unknown"; "": failed
  std::vector<std::string> effects;  ///< missing, together or one of them
  double size_dph = 0;               ///< of what is missing, rms
  std::optional<double> probability;
  std::string sentence;
  std::string next;  ///< command line; "": there is none
};

/// Writes diagnosis.txt in `folder` whole or not at all. Throws InputError where it cannot be
/// written.
void save_diagnosis(const GyroDiagnosis& diagnosis, const std::string& folder);

/// Nothing where there is none, or none of that result.
std::optional<GyroDiagnosis> load_diagnosis(const std::string& folder,
                                            const std::string& fingerprint);

}  // namespace fogcomp::batch
