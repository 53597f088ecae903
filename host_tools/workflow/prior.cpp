#include "workflow/prior.hpp"

#include <algorithm>
#include <cmath>

#include "compare/comparison.hpp"
#include "fit/informed_fit.hpp"
#include "fit/lot.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "model/model_file.hpp"
#include "runs/runs.hpp"
#include "series/block_series.hpp"
#include "support/evidence.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::workflow {
namespace {

void refuse_beside(const std::string& known, const char* option, bool given) {
  if (given) throw InputError(option, "is determined by " + known + "; leave one of the two out");
}

void refuse_gyro_of(const model::Model& older, const FitRequest& request) {
  if (request.serial.empty() || older.serial.empty() || request.serial == older.serial) return;
  throw InputError(*request.prior, "is of gyro " + older.serial + ", not of " + request.serial +
                                       "; give the older model of this gyro");
}

void refuse_samples_of(const model::Model& older, const runs::Run& run) {
  if (!has_any_of(run, older.samples)) return;
  throw InputError(run.file,
                   "has samples to which the older model was fitted, which would count "
                   "twice; give newer recordings, or fit without --prior");
}

std::optional<model::Range> united(const std::optional<model::Range>& older,
                                   const std::optional<model::Range>& range) {
  if (!older || !range) return range;
  return model::Range{std::min(older->min, range->min), std::max(older->max, range->max)};
}

// Of the files of runs: recording::rows_hash.
std::vector<std::uint64_t> hashes_of(const std::vector<runs::Run>& runs) {
  std::vector<std::uint64_t> hashes;
  for (const runs::Run& run : runs) {
    const auto& own = run.blocks.recordings;
    hashes.insert(hashes.end(), own.begin(), own.end());
  }
  return hashes;
}

}  // namespace

fit::Prior KnownBefore::prior(const FitRequest& request,
                              const std::vector<runs::Run>& recordings) const {
  if (!lot) {
    for (const runs::Run& run : recordings) refuse_samples_of(model, run);
    return fit::prior_of(model, *request.prior);
  }
  return fit::prior_of(fit::without_gyro(*lot, request.serial, hashes_of(recordings)),
                       *request.lot);
}

std::optional<KnownBefore> known_before(const FitRequest& request) {
  if (!request.prior && !request.lot) return std::nullopt;
  const std::string& known = request.prior ? *request.prior : *request.lot;
  refuse_beside(known, "--lot", request.prior && request.lot);
  refuse_beside(known, "--effects", request.effects.has_value());
  refuse_beside(known, "--effect-expr", !request.expressions.empty());
  refuse_beside(known, "--model", request.preset.has_value());
  refuse_beside(known, "--derivative-tau", request.derivative_tau_s.has_value());
  KnownBefore before;
  if (request.lot) {
    before.lot = fit::parse_lot(read_file(*request.lot), *request.lot);
    before.model = before.lot->model;
  } else {
    before.model = model::load_model(*request.prior);
    refuse_gyro_of(before.model, request);
  }
  before.prior(request, {});  // throws what it has to before a recording is read
  return before;
}

std::string prior_words(const fit::Identification& identified) {
  const fit::Prior& prior = *identified.prior;
  std::vector<std::string> effects;
  for (const model::EffectTerm& term : prior.terms) effects.push_back(term.name);
  const std::vector<std::string> names = fit::names_of_unknowns(prior.terms);
  std::string words = join(effects, ",") + "; prior: " + prior.file;
  if (prior.gyros > 0) words += " (" + counted(prior.gyros, "gyro") + ")";
  for (std::size_t i = 0; i < names.size(); ++i) {
    const fit::Departure& departure = identified.departures[i];
    if (!departure.is_certain()) continue;
    words += format("; %s by %+.1f sigma", names[i].c_str(), departure.sigmas);
  }
  return words;
}

model::Model with_ranges_of(const model::Model& older, model::Model model) {
  model.min_degc = std::min(older.min_degc, model.min_degc);
  model.max_degc = std::max(older.max_degc, model.max_degc);
  model.rate_range_degc_per_min =
      united(older.rate_range_degc_per_min, model.rate_range_degc_per_min);
  model.time_range_s = united(older.time_range_s, model.time_range_s);
  model.input_rate_range_dph = united(older.input_rate_range_dph, model.input_rate_range_dph);
  model::InputRanges before = older.input_ranges;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (!model.input_ranges[i]) before[i].reset();
  }
  series::widen(model.input_ranges, before);
  return model;
}

double rms_of(const model::Model& model, const std::vector<runs::Run>& runs, double row_s) {
  double squares = 0;
  double rows = 0;
  for (const runs::Run& run : runs) {
    const compare::Comparison comparison = compare::compare_with(model, run, row_s);
    squares += std::pow(comparison.whole.rms_dph, 2) * static_cast<double>(comparison.size());
    rows += static_cast<double>(comparison.size());
  }
  return std::sqrt(squares / rows);
}

void check_lot(const FitRequest& request, std::size_t gyros) {
  if (request.lot) {
    throw InputError("--lot", "is of what each gyro tells alone; leave --prior-lot out");
  }
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
  for (const fit::OwnModel& own : models) {
    lot.model = with_ranges_of(own.model, std::move(lot.model));
  }
  return lot;
}

}  // namespace fogcomp::workflow
