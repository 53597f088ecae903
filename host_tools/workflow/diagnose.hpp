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
  recording::ReadOptions reading;        ///< model_scale_factor is the model's
  std::vector<std::string> expressions;  ///< `NAME = EXPRESSION`: candidates beside the catalogue
  std::optional<std::string> at_rest;    ///< recording that the noise is taken from
  std::vector<std::string> hold_outs;    ///< by which additions are judged, as `add` has them
  int max_steps = 0;                     ///< of the loop; 0: only say what is missing
  std::optional<double> average_s;       ///< rows; nothing: diagnosis::row_length()
  std::uint64_t seed = 1;                ///< of the draws that calibrate the test
};

struct DiagnoseOutcome {
  std::unique_ptr<const model::Model> model;  ///< as given; data refers to it
  diagnosis::DiagnosisData data;
  std::vector<std::string> runs;  ///< that counted: none twice
  diagnosis::Ladder ladder;       ///< without steps where max_steps is 0
};

/// Throws InputError as DiagnosisData::add(), noise_of_static(), read_holdouts() and
/// stepwise_selection() do. Additions are judged in the model's own rows, as `add` does.
DiagnoseOutcome diagnose(const DiagnoseRequest& request, const Observer& observer = {});
/// The same with the request's recordings read before, as judging_runs() does.
DiagnoseOutcome diagnose(const DiagnoseRequest& request, const diagnosis::JudgingRuns& judging,
                         const Observer& observer = {});
diagnosis::JudgingRuns judging_runs(const DiagnoseRequest& request, const Observer& observer = {});

}  // namespace fogcomp::workflow
