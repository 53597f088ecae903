#include "series/signal_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/drift_model.hpp"
#include "model/input_value.hpp"
#include "series/block_walk.hpp"
#include "series/required_inputs.hpp"
#include "series/zero_phase.hpp"

namespace fogcomp {

namespace {

// Of the lags that smooth a temperature, relative to the derivative's: an eighth of its noise is
// left in a rate, and heat that the derivative still follows hardly differs.
constexpr double kSmoothing = 2;

}  // namespace

// Stands where walk_blocks expects a drift model, and keeps what one would see.
class SignalRecorder {
 public:
  SignalRecorder(const Model& model, SignalSeries::Run& run)
      : thermal_(unclamped(thermal_parameters(model, run.block_s))), run_(run) {}

  void start(const RealBlock& block) { keep(thermal_.reset(block), true); }
  void step(const RealBlock& block) { keep(thermal_.step(block), false); }

  /// The block that the signals kept last are valid for.
  SignalSeries::Block& current() { return run_.blocks.back(); }

 private:
  static fog::ThermalParameters<RealNumbers> unclamped(fog::ThermalParameters<RealNumbers> p) {
    p.least = -std::numeric_limits<double>::infinity();
    p.most = std::numeric_limits<double>::infinity();
    return p;
  }
  void keep(const fog::Signals<RealNumbers>& signals, bool restart) {
    run_.blocks.push_back({signals, restart, SignalSeries::kNoRow, 0});
  }

  fog::ThermalState<RealNumbers> thermal_;
  SignalSeries::Run& run_;
};

struct RowSums {
  std::int64_t number = 0;
  double samples = 0;
  double time = 0;
  double drift = 0;
  fog::Signals<RealNumbers> signals;
  fog::BlockMeans<RealNumbers> inputs;
};

namespace {

void add_weighted(double weight, const fog::BlockMeans<RealNumbers>& means,
                  fog::BlockMeans<RealNumbers>& sum) {
  sum.temperature += weight * means.temperature;
  sum.input_rate += weight * means.input_rate;
  sum.elapsed += weight * means.elapsed;
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
    sum.extension[i] += weight * means.extension[i];
  }
}

void add_weighted(double weight, const fog::Signals<RealNumbers>& signals,
                  fog::Signals<RealNumbers>& sum) {
  sum.temperature += weight * signals.temperature;
  sum.temperature_rate += weight * signals.temperature_rate;
  add_weighted(weight, signals.block, sum.block);
}

}  // namespace

// Sums blocks up to rows, and tells every block its row.
class RowCollector {
 public:
  RowCollector(std::int64_t blocks_per_row, Eigen::Index first_row)
      : per_row_(blocks_per_row), first_row_(static_cast<std::int32_t>(first_row)) {}

  void take(const BlockSeries::Block& block, SignalSeries::Block& current) {
    if (sums_.empty() || sums_.back().number != block.number / per_row_) {
      sums_.push_back({block.number / per_row_, 0, 0, 0, {}, {}});
    }
    current.row = first_row_ + static_cast<std::int32_t>(sums_.size()) - 1;
    current.samples = block.samples;
    RowSums& row = sums_.back();
    row.samples += current.samples;
    row.time += current.samples * block.time_s;
    row.drift += current.samples * (block.rate_dph - block.means.input_rate);
    add_weighted(current.samples, current.signals, row.signals);
    add_weighted(current.samples, block.means, row.inputs);
  }
  const std::vector<RowSums>& sums() const { return sums_; }

 private:
  std::int64_t per_row_;
  std::int32_t first_row_;
  std::vector<RowSums> sums_;
};

std::int64_t blocks_per_row(double average_s, double block_s) {
  return std::max(1LL, std::llround(average_s / block_s));
}

double row_length_s(double average_s, double block_s) {
  return static_cast<double>(blocks_per_row(average_s, block_s)) * block_s;
}

void SignalSeries::add(const BlockSeries& series) {
  require_inputs(model_, series);
  runs_.push_back({series.block_s, {}, {}});
  const std::int64_t per_row = blocks_per_row(model_.average_s, series.block_s);
  RowCollector rows(per_row, rows_.size());
  if (phase_ == Phase::board) {
    add_as_the_board(series, rows);
  } else {
    add_without_delay(series, rows);
  }
  rows_.row_s = std::max(rows_.row_s, static_cast<double>(per_row) * series.block_s);
  const double samples = static_cast<double>(per_row) * series.samples_per_block;
  rows_.rounding_dph = std::max(rows_.rounding_dph, series.rounding_dph / std::sqrt(samples));
  append_rows(rows.sums(), series.block_s / series.samples_per_block);
}

void SignalSeries::add_as_the_board(const BlockSeries& series, RowCollector& rows) {
  Run smoothed{series.block_s, {}, {}};
  SignalRecorder smooth_recorder(model_, smoothed);
  walk_blocks(with_smooth_temperature(series, kSmoothing * model_.derivative_tau_s),
              smooth_recorder, [](const BlockSeries::Block&) {});
  for (const Block& block : smoothed.blocks) runs_.back().smoothed.push_back(block.signals);
  SignalRecorder recorder(model_, runs_.back());
  walk_blocks(series, recorder,
              [&](const BlockSeries::Block& block) { rows.take(block, recorder.current()); });
}

void SignalSeries::add_without_delay(const BlockSeries& series, RowCollector& rows) {
  const ZeroPhaseSignals seen = zero_phase_signals(series, model_.derivative_tau_s);
  for (std::size_t i = 0; i < series.blocks.size(); ++i) {
    runs_.back().blocks.push_back({seen.signals[i], seen.restart[i], kNoRow, 0});
    rows.take(series.blocks[i], runs_.back().blocks.back());
  }
}

void SignalSeries::append_rows(const std::vector<RowSums>& sums, double sample_s) {
  const Eigen::Index first = rows_.size();
  const auto size = first + static_cast<Eigen::Index>(sums.size());
  rows_.run_starts.push_back(static_cast<std::size_t>(first));
  rows_.drift_dph.conservativeResize(size);
  seconds_.conservativeResize(size);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const RowSums& row = sums[i];
    const Eigen::Index at = first + static_cast<Eigen::Index>(i);
    rows_.drift_dph[at] = row.drift / row.samples;
    seconds_[at] = row.samples * sample_s;
    rows_.time_s.push_back(row.time / row.samples);
    rows_.signals.emplace_back();
    add_weighted(1 / row.samples, row.signals, rows_.signals.back());
    rows_.inputs.emplace_back();
    add_weighted(1 / row.samples, row.inputs, rows_.inputs.back());
  }
  rows_.weights = seconds_ / rows_.row_s;
}

template <class Make>
Eigen::MatrixXd SignalSeries::row_means(const Make& make, Reading reading) const {
  Eigen::MatrixXd sums;
  Eigen::VectorXd samples = Eigen::VectorXd::Zero(rows_.size());
  Eigen::VectorXd values;
  for (const Run& run : runs_) {
    auto part = make(run.block_s);
    if (sums.size() == 0) {
      values.resize(static_cast<Eigen::Index>(part.size()));
      sums.setZero(rows_.size(), values.size());
    }
    const bool smoothed = reading == Reading::smoothed && !run.smoothed.empty();
    for (std::size_t i = 0; i < run.blocks.size(); ++i) {
      const Block& block = run.blocks[i];
      const fog::Signals<RealNumbers>& signals = smoothed ? run.smoothed[i] : block.signals;
      if (block.restart) part.reset(signals);
      part.step(signals, values.data());
      if (block.row == kNoRow) continue;
      sums.row(block.row) += block.samples * values.transpose();
      samples[block.row] += block.samples;
    }
  }
  return samples.cwiseInverse().asDiagonal() * sums;
}

std::vector<RowRange> Rows::runs() const {
  std::vector<RowRange> runs;
  for (const std::size_t start : run_starts) {
    if (!runs.empty()) runs.back().end = start;
    runs.push_back({start, static_cast<std::size_t>(size())});
  }
  return runs;
}

std::size_t Rows::run_at(std::size_t row) const {
  const auto after = std::upper_bound(run_starts.begin(), run_starts.end(), row);
  return static_cast<std::size_t>(after - run_starts.begin()) - 1;
}

bool Rows::starts_run(std::size_t row) const {
  return std::binary_search(run_starts.begin(), run_starts.end(), row);
}

double Rows::longest_run_s() const {
  double longest_s = 0;
  for (const RowRange& run : runs()) {
    longest_s = std::max(longest_s, time_s[run.end - 1] - time_s[run.first]);
  }
  return longest_s;
}

Eigen::VectorXd SignalSeries::drift_dph(const std::vector<EffectTerm>& terms) const {
  Eigen::VectorXd drift = Eigen::VectorXd::Zero(rows_.size());
  for (const EffectTerm& term : terms) {
    drift += regressors(term) * Eigen::Map<const Eigen::VectorXd>(
                                    term.coefficients_dph.data(),
                                    static_cast<Eigen::Index>(term.coefficients_dph.size()));
  }
  return drift;
}

Eigen::MatrixXd SignalSeries::regressors(const EffectTerm& term, Reading reading) const {
  struct Part {
    std::unique_ptr<RealEffect> effect;
    std::size_t size() const { return effect->regressor_count(); }
    void reset(const fog::Signals<RealNumbers>& signals) { effect->reset(signals); }
    void step(const fog::Signals<RealNumbers>& signals, double* values) {
      effect->step(signals, values);
    }
  };
  return row_means([&](double block_s) { return Part{make_effect(term, block_s)}; }, reading);
}

SignalRanges SignalSeries::signal_ranges() const {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  SignalRanges ranges;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    ranges[i] = {kInfinite, -kInfinite};
    for (const Run& run : runs_) {
      for (const Block& block : run.blocks) {
        const double value = value_of(static_cast<fog::Input>(i), block.signals, run.block_s);
        ranges[i] = {std::min(ranges[i].least, value), std::max(ranges[i].most, value)};
      }
    }
  }
  return ranges;
}

Eigen::MatrixXd SignalSeries::network_inputs(const std::vector<RealInput>& inputs) const {
  struct Part : NetworkSignals {
    using NetworkSignals::NetworkSignals;
    void step(const fog::Signals<RealNumbers>& signals, double* values) {
      const Eigen::VectorXd& now = NetworkSignals::step(signals);
      std::copy(now.begin(), now.end(), values);
    }
  };
  return row_means([&](double block_s) { return Part(inputs, block_s); });
}

}  // namespace fogcomp
