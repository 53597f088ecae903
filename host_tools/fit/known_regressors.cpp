#include "fit/known_regressors.hpp"

#include "model/catalogue.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::fit {
namespace {

// 24 MB: the shapes of two grids of ripples over 6000 rows.
constexpr Eigen::Index kMaxValues = 3'000'000;

// Two expressions may have one name, and an expression two scales.
std::string meaning_of(const model::EffectTerm& term) {
  if (!term.expression) return term.name;
  return term.name + " = " + term.expression->expression.text + " / 2^" +
         std::to_string(term.expression->scale_log2);
}

// An effect with a second part, which is like the first, as two effects without: of two ripples a
// search moves one at a time.
std::vector<model::EffectTerm> parts_of(const model::EffectTerm& term) {
  if (term.expression) return {term};
  const auto& parameters = model::find_effect(term.name).parameters;
  for (std::size_t i = 1; i < parameters.size(); ++i) {
    if (!model::is_optional_part(parameters[i]) || term.parameters[i].value == 0) continue;
    std::vector<model::EffectTerm> parts(2, term);
    parts[1].parameters[i - 1].value = term.parameters[i].value;
    for (model::EffectTerm& part : parts) part.parameters[i].value = 0;
    return parts;
  }
  return {term};
}

}  // namespace

KnownRegressors::KnownRegressors(const model::Model& model, const std::vector<runs::Run>& runs)
    : own_(std::make_shared<series::SignalSeries>(runs::series_of(model, runs))),
      series_(own_.get()) {}

KnownRegressors KnownRegressors::of(series::Reading reading) const {
  KnownRegressors others = *this;
  others.reading_ = reading;
  return others;
}

KnownRegressors::Columns KnownRegressors::operator()(
    const model::EffectTerm& term, series::Reading reading,
    const series::TemperatureChange& change) const {
  const std::vector<model::EffectTerm> parts = parts_of(term);
  if (parts.size() == 1) return of_part(term, reading, change);
  return std::make_shared<const Eigen::MatrixXd>(
      side_by_side({*of_part(parts[0], reading, change), *of_part(parts[1], reading, change)},
                   series_->rows().size()));
}

Eigen::VectorXd KnownRegressors::drift_dph(const std::vector<model::EffectTerm>& terms,
                                           series::Reading reading) const {
  Eigen::VectorXd drift = Eigen::VectorXd::Zero(series_->rows().size());
  for (const model::EffectTerm& own : terms) {
    const model::EffectTerm term = reading == series::Reading::of_gyro ? model::of_gyro(own) : own;
    drift += *(*this)(term, reading) * term.coefficients();
  }
  return drift;
}

KnownRegressors::Columns KnownRegressors::of_part(const model::EffectTerm& term,
                                                  series::Reading reading,
                                                  const series::TemperatureChange& change) const {
  const Key key{meaning_of(term), term.shape(), term.recording,     term.others_part,
                reading,          change.degc,  change.degc_per_min};
  Memory& memory = *memory_;
  {
    const std::lock_guard<std::mutex> lock(memory.mutex);
    const auto found = memory.known.find(key);
    if (found != memory.known.end()) return found->second;
  }
  // Unlocked: this takes long. If two threads compute the same, the first is kept.
  const Columns columns =
      std::make_shared<const Eigen::MatrixXd>(series_->regressors(term, reading, change));
  const std::lock_guard<std::mutex> lock(memory.mutex);
  const auto [place, is_new] = memory.known.emplace(key, columns);
  if (!is_new) return place->second;
  memory.values += columns->size();
  for (; memory.values > kMaxValues && !memory.oldest_first.empty(); memory.oldest_first.pop()) {
    memory.values -= memory.oldest_first.front()->second->size();
    memory.known.erase(memory.oldest_first.front());
  }
  memory.oldest_first.push(place);
  return columns;
}

}  // namespace fogcomp::fit
