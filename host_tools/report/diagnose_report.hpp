#pragma once

#include <string>
#include <vector>

#include "diagnosis/diagnosis_data.hpp"
#include "diagnosis/diagnosis_words.hpp"
#include "report/report.hpp"

namespace fogcomp::report {

/// What `fogcomp diagnose` found in `data`, with plots. `files`: the model, then the runs, as on
/// the command line. The ladder has its section where the loop was wanted (--max-effects).
Report diagnose_report(const Ladder& ladder, bool loop_wanted, const DiagnosisData& data,
                       const std::vector<std::string>& files);

}  // namespace fogcomp::report
