#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model_file.hpp"
#include "runs/decision_rules.hpp"
#include "runs/runs.hpp"
#include "support/text.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

/// Reading options for this model: what they leave open is taken from the model. Uses the observer,
/// which must outlive the reading.
inline recording::ReadOptions reading_for(const model::Model& model,
                                          const recording::ReadOptions& options,
                                          const Observer& observer) {
  recording::ReadOptions reading = observer.with_observer(options);
  reading.model_scale_factor = model.scale_factor;
  reading.model_limits = model.limits;
  reading.model_columns = model.columns;
  reading.model_decimal_comma = model.decimal_comma;
  return reading;
}

/// What the model keeps of the way in which its recordings are read, for further ones.
inline void remember_reading(const recording::ReadOptions& options, model::Model& model) {
  if (!options.columns.empty()) model.columns = options.columns;
  if (options.decimal_comma) model.decimal_comma = options.decimal_comma;
  model.cuts.clear();
  for (const recording::Cut& cut : options.cuts) model.cuts.push_back(cut_text(cut));
}

/// Runs for fitting a model anew, and runs that judge it.
struct JudgingRequest {
  std::string model;                   ///< file
  std::vector<std::string> runs;       ///< recordings to be fitted
  std::vector<std::string> hold_outs;  ///< runs that judge, instead of cross-validation
  recording::ReadOptions reading;      ///< model_scale_factor is replaced by the model's
};

/// Reads them for rows of the model's length, of those of runs::row_length(), and `asked_s`. Throws
/// InputError like runs::read_runs().
inline runs::Runs judging_runs(const JudgingRequest& request, const std::optional<double>& asked_s,
                               const Observer& observer) {
  const model::Model model = model::load_model(request.model);
  std::vector<double> row_lengths_s{asked_s.value_or(model.average_s), model.average_s};
  const auto& usual = runs::rules::kRowLengths_s;
  row_lengths_s.insert(row_lengths_s.end(), usual.begin(), usual.end());
  return runs::read_runs(request.runs, request.hold_outs,
                         reading_for(model, request.reading, observer), row_lengths_s);
}

}  // namespace fogcomp::workflow
