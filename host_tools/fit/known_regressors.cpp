#include "fit/known_regressors.hpp"

namespace fogcomp::fit {
namespace {

// 48 MB: the shapes of two grids of two ripples over 6000 rows.
constexpr Eigen::Index kMaxValues = 6'000'000;

}  // namespace

KnownRegressors::Columns KnownRegressors::operator()(const model::EffectTerm& term,
                                                     series::Reading reading) {
  const Key key{term.name, term.parameters, term.recording, term.others_follow, reading};
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
