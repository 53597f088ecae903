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
    : own_(std::make_unique<series::SignalSeries>(runs::series_of(model, runs))), series_(*own_) {}

KnownRegressors::Columns KnownRegressors::operator()(const model::EffectTerm& term,
                                                     series::Reading reading) const {
  const std::vector<model::EffectTerm> parts = parts_of(term);
  if (parts.size() == 1) return of_part(term, reading);
  return std::make_shared<const Eigen::MatrixXd>(side_by_side(
      {*of_part(parts[0], reading), *of_part(parts[1], reading)}, series_.rows().size()));
}

KnownRegressors::Columns KnownRegressors::of_part(const model::EffectTerm& term,
                                                  series::Reading reading) const {
  const Key key{meaning_of(term), term.shape(), term.recording, term.others_part, reading};
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = known_.find(key);
    if (found != known_.end()) return found->second;
  }
  // Unlocked: this takes long. If two threads compute the same, the first is kept.
  const Columns columns =
      std::make_shared<const Eigen::MatrixXd>(series_.regressors(term, reading));
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto [place, is_new] = known_.emplace(key, columns);
  if (!is_new) return place->second;
  values_ += columns->size();
  for (; values_ > kMaxValues && !oldest_first_.empty(); oldest_first_.pop()) {
    values_ -= oldest_first_.front()->second->size();
    known_.erase(oldest_first_.front());
  }
  oldest_first_.push(place);
  return columns;
}

}  // namespace fogcomp::fit
