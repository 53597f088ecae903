#pragma once

#include <string>

#include "findings/document.hpp"
#include "workflow/plan.hpp"

namespace fogcomp::findings {

/// Output of `fogcomp plan`: the steps for an operator, what they would show, how long to record.
/// `profile`: the written file.
Document plan_findings(const workflow::PlanOutcome& outcome, const std::string& profile);

/// Output of `fogcomp plan --compare`: programmes side by side.
Document comparison_findings(const workflow::PlanComparison& comparison);

}  // namespace fogcomp::findings
