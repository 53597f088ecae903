#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/ladder.hpp"
#include "diagnosis/next_step.hpp"
#include "workflow/reading.hpp"

namespace fogcomp::workflow {

struct DiagnoseRequest : JudgingRequest {
  std::vector<std::string> expressions;  ///< `NAME = EXPRESSION`: candidates beside the catalogue
  std::optional<std::string> at_rest;    ///< recording that determines the noise
  int max_steps = 0;                     ///< of the stepwise selection; 0: diagnose only
  std::optional<double> average_s;       ///< rows of one look; else those of runs::row_length()
};

struct DiagnoseOutcome {
  diagnosis::DiagnosisData data;
  std::vector<std::string> runs;  ///< without duplicates
  diagnosis::Ladder ladder;       ///< without steps if max_steps is 0
};

/// Throws InputError like DiagnosisData, noise_of_static(), runs::read_runs() and
/// stepwise_selection(). Additions are judged in rows of runs::row_length(), like `add`.
DiagnoseOutcome diagnose(const DiagnoseRequest& request, const Observer& observer = {});
/// The same with recordings already read by judging_runs().
DiagnoseOutcome diagnose(const DiagnoseRequest& request, const runs::Runs& judging,
                         const Observer& observer = {});

}  // namespace fogcomp::workflow
