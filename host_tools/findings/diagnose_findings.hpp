#pragma once

#include <string>
#include <vector>

#include "diagnosis/diagnosis_data.hpp"
#include "findings/diagnosis_words.hpp"
#include "findings/document.hpp"

namespace fogcomp::findings {

/// What `fogcomp diagnose` found in `data`, with plots. The ladder has its section where the loop
/// was wanted (--max-effects).
Document diagnose_findings(const diagnosis::Ladder& ladder, bool loop_wanted,
                           const diagnosis::DiagnosisData& data, const DiagnosedFiles& files);

}  // namespace fogcomp::findings
