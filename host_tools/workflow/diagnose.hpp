#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/ladder.hpp"
#include "diagnosis/next_step.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

struct DiagnoseRequest {
  std::string model;                     ///< file
  std::vector<std::string> runs;         ///< recordings
  recording::ReadOptions reading;        ///< model_scale_factor is replaced by the model's
  std::vector<std::string> expressions;  ///< `NAME = EXPRESSION`: candidates beside the catalogue
  std::optional<std::string> at_rest;    ///< recording that determines the noise
  std::vector<std::string> hold_outs;    ///< runs that judge additions, as for `add`
  int max_steps = 0;                     ///< of the stepwise selection; 0: diagnose only
  std::optional<double> average_s;       ///< rows of one look; else those of fit::row_length()
  std::uint64_t seed = 1;                ///< of the random draws of the test
};

struct DiagnoseOutcome {
  std::unique_ptr<const model::Model> model;  ///< as given; `data` refers to it
  diagnosis::DiagnosisData data;
  std::vector<std::string> runs;  ///< without duplicates
  diagnosis::Ladder ladder;       ///< without steps if max_steps is 0
};

/// Throws InputError like DiagnosisData::add(), noise_of_static(), read_holdouts() and
/// stepwise_selection(). Additions are judged in rows of fit::row_length(), like `add`.
DiagnoseOutcome diagnose(const DiagnoseRequest& request, const Observer& observer = {});
/// The same with recordings already read by judging_runs().
DiagnoseOutcome diagnose(const DiagnoseRequest& request, const diagnosis::JudgingRuns& judging,
                         const Observer& observer = {});
diagnosis::JudgingRuns judging_runs(const DiagnoseRequest& request, const Observer& observer = {});

}  // namespace fogcomp::workflow
