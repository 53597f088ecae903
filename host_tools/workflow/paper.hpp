#pragma once

#include <string>
#include <vector>

#include "research/gyros.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

struct PaperRequest {
  research::StudySettings study;
  std::size_t gyros = 1;  ///< with seeds from the study's on
};

/// Names of all models that a study can have.
std::vector<std::string> study_models();
/// Of a list `NAME,NAME` or `all`, with bp and pso-bp, which the paper's tables are about. Throws
/// InputError naming the nearest.
std::vector<std::string> study_models(const std::string& list);

std::vector<research::Study> paper(const PaperRequest& request, const Observer& observer = {});

}  // namespace fogcomp::workflow
