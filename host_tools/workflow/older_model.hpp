#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fit/identify.hpp"
#include "fit/lot.hpp"
#include "model/model.hpp"
#include "runs/runs.hpp"
#include "workflow/fit.hpp"

/// A fit that goes on with an older model of the same gyro (FitRequest::prior), or with what its
/// lot has taught (FitRequest::lot).
namespace fogcomp::workflow {

/// What is known before a fit.
struct KnownBefore {
  model::Model model;           ///< the older one, or that of the lot's mean gyro
  std::optional<fit::Lot> lot;  ///< nothing: an older model

  /// Of a gyro with this number and these recordings, which a lot's prior does not contain.
  fit::Prior prior(const FitRequest& request, const std::vector<runs::Run>& recordings) const;
};
/// Nothing if the request names none. Throws InputError for a model of another gyro, for a file
/// that is no prior, and for settings that it determines.
std::optional<KnownBefore> known_before(const FitRequest& request);

/// Of the files of runs: recording::rows_hash.
std::vector<std::uint64_t> hashes_of(const std::vector<runs::Run>& runs);

/// The effects, whose they were, and what has moved, for the history.
std::string prior_words(const fit::Identification& identified);

/// What the older model was trained for, `model` is as well.
void unite_ranges(const model::Model& older, model::Model& model);

/// Rms error of a model on all runs, deg/h, over means of `row_s`.
double rms_of(const model::Model& model, const std::vector<runs::Run>& runs, double row_s);

}  // namespace fogcomp::workflow
