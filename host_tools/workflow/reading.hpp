#pragma once

#include "model/model.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

/// The options with which a recording is read for this model: what they leave open is as the model
/// has it. Heard by the observer, which must outlive the reading.
inline recording::ReadOptions reading_for(const model::Model& model,
                                          const recording::ReadOptions& options,
                                          const Observer& observer) {
  recording::ReadOptions reading = observer.heard(options);
  reading.model_scale_factor = model.scale_factor;
  reading.model_limits = model.limits;
  reading.model_columns = model.columns;
  return reading;
}

}  // namespace fogcomp::workflow
