#include "workflow/lot.hpp"

#include "fit/informed_fit.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "model/model_file.hpp"
#include "runs/runs.hpp"
#include "support/evidence.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "workflow/fit_presets.hpp"
#include "workflow/older_model.hpp"

namespace fogcomp::workflow {

void check_lot(const FitRequest& request, std::size_t gyros) {
  if (wanted_model(request).network.hidden > 0) {
    throw InputError("--lot", "knows effects, and no network; leave one of the two out");
  }
  if (gyros < kMinLot) {
    throw InputError("--lot", format("needs at least %zu gyros, here are %zu; record more, or "
                                     "leave it out",
                                     kMinLot, gyros));
  }
}

fit::Lot learn_lot(const FitRequest& request, const std::vector<FittedGyro>& gyros) {
  std::vector<fit::OwnModel> models;
  for (const FittedGyro& gyro : gyros)
    models.push_back({gyro.model_file, model::load_model(gyro.model_file)});
  const auto refit = [&](std::size_t i, const fit::Prior& prior) {
    FitRequest own = request;
    own.runs = gyros[i].recordings;
    const runs::Runs runs = training_runs(own);
    const fit::KnownRegressors known(models[i].model, runs.training);
    const fit::InformedFit found =
        fit::fit_with_prior(known, prior, fit::run_offset_columns(known.series().rows()));
    return fit::Sister{models[i].model.serial, hashes_of(runs.training), found.seen,
                       found.board_less_gyro, fit::noise_of(models[i].model)};
  };
  fit::Lot lot = fit::learn_lot(models, refit);
  for (const fit::OwnModel& own : models) unite_ranges(own.model, lot.model);
  return lot;
}

}  // namespace fogcomp::workflow
