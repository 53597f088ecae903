#pragma once

#include <string>
#include <vector>

#include "case_result.hpp"

namespace fogcomp::bench {

/// Truth against answer: one line per hidden effect, with the answers and their counts. Cases with
/// one effect, with a disturbance, and clean ones.
std::string confusion_table(const std::vector<CaseResult>& results);
/// How often the truth was named or in the set, by a property of the case.
std::string by_effect(const std::vector<CaseResult>& results);
std::string by_size(const std::vector<CaseResult>& results);
std::string by_programme(const std::vector<CaseResult>& results);
/// Clean cases, by their flicker noise.
std::string clean_by_flicker(const std::vector<CaseResult>& results);
/// Every wrong single name, with its case.
std::string wrong_names(const std::vector<CaseResult>& results);
/// A line per case.
std::string cases_csv(const std::vector<CaseResult>& results);

}  // namespace fogcomp::bench
