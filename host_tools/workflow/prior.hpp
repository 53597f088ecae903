#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/identify.hpp"
#include "fit/lot.hpp"
#include "model/model.hpp"
#include "runs/runs.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::workflow {

/// What is known before a fit: an older model of the same gyro (FitRequest::prior), or what its lot
/// has taught (FitRequest::lot).
struct KnownBefore {
  model::Model model;           ///< the older one, or that of the lot's mean gyro
  std::optional<fit::Lot> lot;  ///< nothing: an older model

  /// Of a gyro with this number and these recordings, which a lot's prior does not contain.
  fit::Prior prior(const FitRequest& request, const std::vector<runs::Run>& recordings) const;
};
/// Nothing if the request names none. Throws InputError for a model of another gyro, for a file
/// that is no prior, and for settings that it determines.
std::optional<KnownBefore> known_before(const FitRequest& request);

/// The effects, whose they were, and what has moved, for the history.
std::string prior_words(const fit::Identification& identified);

/// `model`, which is trained for what the older one was, as well.
model::Model with_ranges_of(const model::Model& older, model::Model model);

/// Rms error of a model on all runs, deg/h, over means of `row_s`.
double rms_of(const model::Model& model, const std::vector<runs::Run>& runs, double row_s);

/// A gyro that has been fitted.
struct FittedGyro {
  std::vector<std::string> recordings;  ///< to which its model was fitted
  std::string model_file;
};

/// Throws InputError for a fit, or a number of gyros, of which no lot can be learnt.
void check_lot(const FitRequest& request, std::size_t gyros);

/// What gyros of one design teach a further one. `request`: of their fits; its recordings are
/// replaced. Reads each recording several times, so that it need not remember
/// them. Throws InputError like fit::learn_lot().
fit::Lot learn_lot(const FitRequest& request, const std::vector<FittedGyro>& gyros);

}  // namespace fogcomp::workflow
