#pragma once

#include <string>
#include <vector>

#include "research/study.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

struct PaperRequest {
  research::StudySettings study;
  std::size_t gyros = 1;  ///< with consecutive seeds
};

/// Names of all models of a study.
std::vector<std::string> study_models();
/// Parses `NAME,NAME` or `all`; bp and pso-bp, which the paper's tables contain, are always
/// included. Throws InputError with the nearest name.
std::vector<std::string> study_models(const std::string& list);

std::vector<research::Study> paper(const PaperRequest& request, const Observer& observer = {});

}  // namespace fogcomp::workflow
