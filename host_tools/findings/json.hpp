#pragma once

#include <string>
#include <vector>

#include "batch/summary.hpp"
#include "compare/model_on_runs.hpp"
#include "compare/run_summary.hpp"
#include "diagnosis/ladder.hpp"
#include "findings/diagnosis_words.hpp"
#include "fit/add_effect.hpp"
#include "research/study.hpp"
#include "support/json.hpp"
#include "workflow/fit.hpp"

/// What `--json` prints: every figure of a finding, by the names that scripts rely on.
namespace fogcomp::findings {

Json info_json(const recording::Recording& recording, const compare::RunSummary& summary);

/// `output`: the model file that was written.
Json fit_json(const workflow::FitOutcome& fit, const std::string& output);

/// The first model's runs at the top; all under "models".
Json compare_json(const std::vector<compare::ModelOnRuns>& models);

Json diagnosis_json(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next,
                    const DiagnosedFiles& files);
/// The diagnosis of the model as given, the steps of the loop, and the diagnosis at its end, which
/// is of no file.
Json ladder_json(const diagnosis::Ladder& ladder, const DiagnosedFiles& files);

/// `written`: the model file that was written, "" for none.
Json add_json(const fit::Addition& addition, const std::string& written);

Json paper_json(const std::vector<research::Study>& studies);

/// Of the second run, the third, ... beside the first, certain or not.
Json turn_on_json(const std::vector<compare::TurnOnBias>& turn_on);

/// `output`: folder of the results. `calibrated`, `already_done`: gyros, now and before.
Json batch_json(const batch::Summary& summary, const std::string& output, std::size_t calibrated,
                std::size_t already_done);

/// Shape parameters and coefficients by their names, coefficients in their own units.
void set_parameters(Json& object, const model::EffectTerm& term);
void set_coefficients(Json& object, const model::EffectTerm& term);

}  // namespace fogcomp::findings
