#pragma once

#include <map>
#include <queue>
#include <string>
#include <tuple>
#include <vector>

#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// Regressors of the terms of one fit, kept as long as there is room: rounds, starts and folds of a
/// search come back to the same shapes.
class KnownRegressors {
 public:
  explicit KnownRegressors(const series::SignalSeries& series) : series_(series) {}

  const series::SignalSeries& series() const { return series_; }
  /// As SignalSeries::regressors(). A name means the same effect or expression in every call. Valid
  /// until the next call.
  const Eigen::MatrixXd& operator()(const model::EffectTerm& term,
                                    series::Reading reading = series::Reading::of_sensor);

 private:
  using Key = std::tuple<std::string, std::vector<double>, series::Reading>;
  using Known = std::map<Key, Eigen::MatrixXd>;

  const series::SignalSeries& series_;
  Known known_;
  std::queue<Known::iterator> oldest_first_;
  Eigen::Index values_ = 0;  // in all of them
};

}  // namespace fogcomp::fit
