#pragma once

#include <string>
#include <vector>

#include "diagnosis/diagnosis_data.hpp"
#include "findings/diagnosis_words.hpp"
#include "findings/document.hpp"

namespace fogcomp::findings {

/// What `fogcomp diagnose` found in `data`, with plots. `files`: the model, then the runs, as on
/// the command line. The ladder has its section where the loop was wanted (--max-effects).
Document diagnose_findings(const diagnosis::Ladder& ladder, const diagnosis::NextStep& next,
                           bool loop_wanted, const diagnosis::DiagnosisData& data,
                           const std::vector<std::string>& files);

}  // namespace fogcomp::findings
