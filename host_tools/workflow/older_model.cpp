#include "workflow/older_model.hpp"

#include <algorithm>
#include <cmath>

#include "compare/comparison.hpp"
#include "model/model_file.hpp"
#include "series/block_series.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::workflow {
namespace {

void refuse_beside_prior(const char* option, bool given) {
  if (given) throw InputError(option, "is determined by --prior; leave one of the two out");
}

void unite(const std::optional<model::Range>& older, std::optional<model::Range>& range) {
  if (!older || !range) return;
  *range = {std::min(older->min, range->min), std::max(older->max, range->max)};
}

}  // namespace

std::optional<model::Model> older_model(const FitRequest& request) {
  if (!request.prior) return std::nullopt;
  refuse_beside_prior("--effects", request.effects.has_value());
  refuse_beside_prior("--effect-expr", !request.expressions.empty());
  refuse_beside_prior("--model", request.preset.has_value());
  refuse_beside_prior("--derivative-tau", request.derivative_tau_s.has_value());
  model::Model older = model::load_model(*request.prior);
  if (!request.serial.empty() && !older.serial.empty() && request.serial != older.serial) {
    throw InputError(*request.prior, "is of gyro " + older.serial + ", not of " + request.serial +
                                         "; give the older model of this gyro");
  }
  return older;
}

std::string prior_words(const fit::Identification& identified) {
  const fit::Prior& prior = *identified.prior;
  std::vector<std::string> effects;
  for (const model::EffectTerm& term : prior.terms) effects.push_back(term.name);
  const std::vector<std::string> names = fit::names_of_unknowns(prior.terms);
  std::string words = join(effects, ",") + "; prior: " + prior.file;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const fit::Departure& departure = identified.departures[i];
    if (!departure.is_certain()) continue;
    words += format("; %s by %+.1f sigma", names[i].c_str(), departure.sigmas);
  }
  return words;
}

void unite_ranges(const model::Model& older, model::Model& model) {
  model.min_degc = std::min(older.min_degc, model.min_degc);
  model.max_degc = std::max(older.max_degc, model.max_degc);
  unite(older.rate_range_degc_per_min, model.rate_range_degc_per_min);
  unite(older.time_range_s, model.time_range_s);
  unite(older.input_rate_range_dph, model.input_rate_range_dph);
  model::InputRanges before = older.input_ranges;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (!model.input_ranges[i]) before[i].reset();
  }
  series::widen(model.input_ranges, before);
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

}  // namespace fogcomp::workflow
