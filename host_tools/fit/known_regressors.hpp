#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <queue>
#include <string>
#include <tuple>
#include <vector>

#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// Regressors of the terms of one fit, kept as long as there is room: rounds, starts and folds of a
/// search come back to the same shapes. Several threads may ask at once.
class KnownRegressors {
 public:
  using Columns = std::shared_ptr<const Eigen::MatrixXd>;

  explicit KnownRegressors(const series::SignalSeries& series) : series_(series) {}

  const series::SignalSeries& series() const { return series_; }
  /// As SignalSeries::regressors(). A name means the same effect or expression in every call.
  Columns operator()(const model::EffectTerm& term,
                     series::Reading reading = series::Reading::of_sensor);

 private:
  using Key = std::tuple<std::string, std::vector<double>, std::optional<std::uint64_t>, bool,
                         series::Reading>;
  using Known = std::map<Key, Columns>;

  const series::SignalSeries& series_;
  std::mutex mutex_;  // guards all below
  Known known_;
  std::queue<Known::iterator> oldest_first_;
  Eigen::Index values_ = 0;  // in all of them
};

}  // namespace fogcomp::fit
