#pragma once

#include <string>
#include <vector>

#include "diagnosis/diagnosis_data.hpp"
#include "diagnosis/ladder.hpp"
#include "findings/document.hpp"
#include "findings/next_step_words.hpp"

namespace fogcomp::findings {

/// The stepwise selection: what each step left, why it ended, and the commands that make its model.
/// `names`: from outside, within our own words.
Parts ladder_section(const diagnosis::Ladder& ladder, const DiagnosedFiles& files,
                     const std::vector<std::string>& names);

/// What to do with the model that a selection wrote to files.output, whatever its steps
/// were: to export the model if nothing is missing; to go on if only the limit of steps ended it;
/// else, or if no board can run it, to see what it leaves, on the first holdout if there is one.
Next next_after_ladder(const diagnosis::Ladder& ladder, const diagnosis::DiagnosisData& data,
                       const DiagnosedFiles& files);

}  // namespace fogcomp::findings
