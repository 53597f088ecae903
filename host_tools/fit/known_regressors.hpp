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

#include "runs/run.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// A series and the regressors of its terms, kept as long as there is room: rounds, starts and
/// folds of a search come back to the same shapes, and so do fits of one series. Several threads
/// may ask at once. A fit takes a series as well, which it then remembers for itself alone.
class KnownRegressors {
 public:
  using Columns = std::shared_ptr<const Eigen::MatrixXd>;

  // NOLINTNEXTLINE(google-explicit-constructor): see above
  KnownRegressors(const series::SignalSeries& series) : series_(&series) {}
  /// Of runs::series_of(), for several fits of one set of runs.
  KnownRegressors(const model::Model& model, const std::vector<runs::Run>& runs);
  /// The same series and memory for fits of another reading.
  KnownRegressors of(series::Reading reading) const;

  const series::SignalSeries& series() const { return *series_; }
  /// As SignalSeries::regressors(), of the reading that is fitted or of another.
  Columns operator()(const model::EffectTerm& term) const { return (*this)(term, reading_); }
  Columns operator()(const model::EffectTerm& term, series::Reading reading,
                     const series::TemperatureChange& change = {}) const;
  /// As SignalSeries::drift_dph().
  Eigen::VectorXd drift_dph(const std::vector<model::EffectTerm>& terms,
                            series::Reading reading) const;
  series::Reading reading() const { return reading_; }

 private:
  using Key = std::tuple<std::string, std::vector<double>, std::optional<std::uint64_t>, double,
                         series::Reading, double, double>;
  using Known = std::map<Key, Columns>;
  struct Memory {
    std::mutex mutex;  // guards all below
    Known known;
    std::queue<Known::iterator> oldest_first;
    Eigen::Index values = 0;  // in all of them
  };

  Columns of_part(const model::EffectTerm& term, series::Reading reading,
                  const series::TemperatureChange& change) const;

  std::shared_ptr<const series::SignalSeries> own_;  // of which nobody else takes care
  const series::SignalSeries* series_;
  series::Reading reading_ = series::Reading::of_sensor;
  std::shared_ptr<Memory> memory_ = std::make_shared<Memory>();
};

}  // namespace fogcomp::fit
