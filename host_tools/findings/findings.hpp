#pragma once

#include <string>
#include <vector>

#include "batch/summary.hpp"
#include "compare/model_on_runs.hpp"
#include "compare/run_summary.hpp"
#include "diagnosis/diagnosis_data.hpp"
#include "diagnosis/ladder.hpp"
#include "findings/diagnosis_words.hpp"
#include "findings/document.hpp"
#include "findings/next_step_words.hpp"
#include "fit/add_effect.hpp"
#include "model/model.hpp"
#include "planning/first_model.hpp"
#include "recording/recording.hpp"
#include "research/study.hpp"
#include "workflow/fit.hpp"
#include "workflow/plan.hpp"

namespace fogcomp::findings {

// What each command found, as its user reads it.

/// Output of `fogcomp info`, with plots. `summary` and `prospect` are those of `recording`.
Document info_findings(const recording::Recording& recording, const compare::RunSummary& summary,
                       const planning::Prospect& prospect = {});

/// `model`: its FitOutcome::on_its_runs().
Document fit_findings(const workflow::FitOutcome& fit, const compare::ModelOnRuns& model);

/// With plots. The best model, with the smallest rms on its worst run, comes first, and is on top
/// in plots of several; plots for a single model show the best one.
Document compare_findings(const std::vector<compare::ModelOnRuns>& models);

/// With plots. The stepwise selection has a section if it was requested (--max-effects).
Document diagnose_findings(const diagnosis::Ladder& ladder, bool loop_wanted,
                           const diagnosis::DiagnosisData& data, const DiagnosedFiles& files);

/// With plots of every run before and after. `model`: the original model; `written`: the new file,
/// "" if none was written.
Document add_findings(const fit::Addition& addition, const std::string& model,
                      const std::string& written);

/// What was done to make a model, and what it has become: steps, errors, coefficients.
Document history_findings(const model::Model& model, const std::string& file);

/// The steps for an operator, what they would show, how long to record. `profile`: the written
/// file.
Document plan_findings(const workflow::PlanOutcome& outcome, const std::string& profile);

/// Output of `fogcomp plan --compare`: programmes side by side.
Document comparison_findings(const workflow::PlanComparison& comparison);

/// The index page of a batch: who passes, who fails and why, and the distribution of every value
/// over the gyros. `input`: folder of recordings; `output`: folder of results and of this page.
/// `reports`: each gyro has SERIAL/report.html.
Document batch_findings(const batch::Summary& summary, const std::string& input,
                        const std::string& output, bool reports);

/// The reference paper's figures 1, 3, 4, 8, 9, 10 and Tables 1 to 3 for the first gyro, with the
/// printed values, and medians over all gyros. Throws InputError if the study lacks bp or pso-bp.
Document paper_findings(const std::vector<research::Study>& studies);

/// What each step of a model left on the data of its last fit. The model has a history.
Table error_ladder(const model::Model& model);

/// The size from which on each effect is visible, beside its typical size. `measured`: the rows
/// over which sizes are an rms.
Table visible_table(const std::vector<planning::VisibleSize>& sizes, const std::string& measured);

/// What a fit made of its prior: which coefficients the recordings moved, by how many standard
/// deviations. Nothing without a prior.
Parts prior_section(const workflow::FitOutcome& fit);

/// Result of the comparison of a network with the effects alone, one line; "" without one.
std::string network_verdict(const fit::FitResult& fit);

/// One sentence for each bias but the first, where power-ons and parts of cut runs have their own.
std::vector<Text> own_bias_words(const fit::Identification& identified);

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
