#pragma once

#include <string>
#include <utility>
#include <vector>

#include "diagnosis/next_step.hpp"
#include "model/model.hpp"
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
  return reading;
}

/// Description of the masks for a model's history; "" for none.
inline std::string mask_words(const recording::ReadOptions& reading) {
  std::string words;
  for (const recording::Mask& mask : reading.masks) {
    words += " --mask " + (mask.run.empty() ? "" : mask.run + ":") +
             format("%.10g..%.10g", mask.from_s, mask.to_s);
  }
  return words;
}

/// Reads runs for fitting `model` and runs for judging it, in its rows. Notes of both are in the
/// notes of the training runs. Throws InputError like read_training_runs() and read_holdouts().
inline diagnosis::JudgingRuns read_judging_runs(const model::Model& model,
                                                const std::vector<std::string>& runs,
                                                const std::vector<std::string>& hold_outs,
                                                const recording::ReadOptions& options,
                                                const Observer& observer) {
  const recording::ReadOptions reading = reading_for(model, options, observer);
  diagnosis::JudgingRuns judging{fit::read_training_runs(runs, reading, model.average_s), {}};
  fit::Holdouts read =
      fit::read_holdouts(hold_outs, reading, model.average_s, judging.training.runs);
  std::vector<std::string>& notes = judging.training.notes;
  notes.insert(notes.end(), read.notes.begin(), read.notes.end());
  judging.holdouts = std::move(read.runs);
  return judging;
}

}  // namespace fogcomp::workflow
