#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fogcomp::batch {

/// Diagnosis of a gyro's model on its recordings.
struct GyroDiagnosis {
  std::string fingerprint;  ///< of the result that it belongs to
  std::string verdict;      ///< "none", "missing_effect", "ambiguous", "unknown"; "": failed
  std::vector<std::string> effects;  ///< missing together, or one of them
  double size_dph = 0;               ///< rms of the missing part
  std::optional<double> probability;
  std::string sentence;
  std::string next;  ///< command line; "": none
};

/// Writes diagnosis.txt in `folder`, completely or not at all. Throws InputError if that fails.
void save_diagnosis(const GyroDiagnosis& diagnosis, const std::string& folder);

/// Nothing if there is no diagnosis of that result.
std::optional<GyroDiagnosis> load_diagnosis(const std::string& folder,
                                            const std::string& fingerprint);

}  // namespace fogcomp::batch
