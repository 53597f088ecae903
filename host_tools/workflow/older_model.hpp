#pragma once

#include <optional>

#include "fit/identify.hpp"
#include "model/model.hpp"
#include "runs/runs.hpp"
#include "workflow/fit.hpp"

/// A fit that goes on with an older model of the same gyro (FitRequest::prior).
namespace fogcomp::workflow {

/// Nothing if the request names none. Throws InputError for a model of another gyro, and for
/// settings that the older model determines.
std::optional<model::Model> older_model(const FitRequest& request);

/// The effects, whose they were, and what has moved, for the history.
std::string prior_words(const fit::Identification& identified);

/// What the older model was trained for, `model` is as well.
void unite_ranges(const model::Model& older, model::Model& model);

/// Rms error of a model on all runs, deg/h, over means of `row_s`.
double rms_of(const model::Model& model, const std::vector<runs::Run>& runs, double row_s);

}  // namespace fogcomp::workflow
