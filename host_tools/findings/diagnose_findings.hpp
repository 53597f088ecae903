#pragma once

#include <string>
#include <vector>

#include "diagnosis/diagnosis_data.hpp"
#include "findings/diagnosis_words.hpp"
#include "findings/document.hpp"

namespace fogcomp::findings {

/// Findings of `fogcomp diagnose` in `data`, with plots. The stepwise selection has a section if it
/// was requested (--max-effects).
Document diagnose_findings(const diagnosis::Ladder& ladder, bool loop_wanted,
                           const diagnosis::DiagnosisData& data, const DiagnosedFiles& files);

}  // namespace fogcomp::findings
