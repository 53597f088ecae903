#include "fit/known_regressors.hpp"

namespace fogcomp::fit {
namespace {

constexpr Eigen::Index kMaxValues = 3'000'000;  // 24 MB: the shapes of two grids over 6000 rows

}  // namespace

const Eigen::MatrixXd& KnownRegressors::operator()(const model::EffectTerm& term,
                                                   series::Reading reading) {
  const Key key{term.name, term.parameters, reading};
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  const auto place = known_.emplace(key, series_.regressors(term, reading)).first;
  values_ += place->second.size();
  for (; values_ > kMaxValues && !oldest_first_.empty(); oldest_first_.pop()) {
    values_ -= oldest_first_.front()->second.size();
    known_.erase(oldest_first_.front());
  }
  oldest_first_.push(place);
  return place->second;
}

}  // namespace fogcomp::fit
