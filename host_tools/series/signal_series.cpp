#include "series/signal_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/drift_model.hpp"
#include "model/input_value.hpp"
#include "series/block_walk.hpp"
#include "series/decision_rules.hpp"
#include "series/required_inputs.hpp"
#include "series/zero_phase.hpp"

namespace fogcomp::series {

// Stands where walk_blocks expects a drift model, and keeps what one would see.
class SignalSeries::Recorder {
 public:
  Recorder(const model::Model& model, Run& run)
      : thermal_(unclamped(model::thermal_parameters(model, run.block_s))), run_(run) {}

  void start(const model::RealBlock& block) { keep(thermal_.reset(block), true); }
  void step(const model::RealBlock& block) { keep(thermal_.step(block), false); }
  void see_rate(double input_rate_dph) { current().input_rate_dph = input_rate_dph; }

  /// The block that the signals kept last are valid for.
  Block& current() { return run_.blocks.back(); }

 private:
  static fog::ThermalParameters<model::RealNumbers> unclamped(
      fog::ThermalParameters<model::RealNumbers> p) {
    p.least = -std::numeric_limits<double>::infinity();
    p.most = std::numeric_limits<double>::infinity();
    return p;
  }
  void keep(const fog::Signals<model::RealNumbers>& signals, bool restart) {
    run_.blocks.push_back({signals, restart, signals.block.input_rate, kNoRow, 0});
  }

  fog::ThermalState<model::RealNumbers> thermal_;
  Run& run_;
};

void SignalSeries::add(const BlockSeries& series) {
  require_inputs(model_, series);
  runs_.push_back({series.block_s, {}, {}});
  RowAverager rows(series, model_.average_s, rows_);
  if (phase_ == Phase::board) {
    add_as_the_board(series, rows);
  } else {
    add_without_delay(series, rows);
  }
  rows.finish();
}

void SignalSeries::add_as_the_board(const BlockSeries& series, RowAverager& rows) {
  Run smoothed{series.block_s, {}, {}};
  Recorder smooth_recorder(model_, smoothed);
  walk_blocks(with_smooth_temperature(series, rules::kSmoothing * model_.derivative_tau_s),
              smooth_recorder, [](const BlockSeries::Block&) {});
  for (const Block& block : smoothed.blocks) runs_.back().smoothed.push_back(block.signals);
  Recorder recorder(model_, runs_.back());
  walk_blocks(series, recorder, [&](const BlockSeries::Block& block) {
    Block& current = recorder.current();
    current.row = rows.take(block, current.signals);
    current.samples = block.samples;
  });
}

void SignalSeries::add_without_delay(const BlockSeries& series, RowAverager& rows) {
  const ZeroPhaseSignals seen = zero_phase_signals(series, model_.derivative_tau_s);
  for (std::size_t i = 0; i < series.blocks.size(); ++i) {
    const BlockSeries::Block& block = series.blocks[i];
    runs_.back().blocks.push_back({seen.signals[i], seen.restart[i], block.means.input_rate,
                                   rows.take(block, seen.signals[i]), double(block.samples)});
  }
}

template <class Make>
Eigen::MatrixXd SignalSeries::row_means(const Make& make, Reading reading,
                                        bool follows_rate) const {
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
      fog::Signals<model::RealNumbers> signals = smoothed ? run.smoothed[i] : block.signals;
      if (follows_rate) signals.block.input_rate = block.input_rate_dph;
      if (block.restart) part.reset(signals);
      part.step(signals, values.data());
      if (block.row == kNoRow) continue;
      sums.row(block.row) += block.samples * values.transpose();
      samples[block.row] += block.samples;
    }
  }
  return samples.cwiseInverse().asDiagonal() * sums;
}

Eigen::VectorXd SignalSeries::drift_dph(const std::vector<model::EffectTerm>& terms) const {
  Eigen::VectorXd drift = Eigen::VectorXd::Zero(rows_.size());
  for (const model::EffectTerm& term : terms) {
    drift += regressors(term) * Eigen::Map<const Eigen::VectorXd>(
                                    term.coefficients_dph.data(),
                                    static_cast<Eigen::Index>(term.coefficients_dph.size()));
  }
  return drift;
}

Eigen::MatrixXd SignalSeries::regressors(const model::EffectTerm& term, Reading reading) const {
  struct Part {
    std::unique_ptr<model::RealEffect> effect;
    std::size_t size() const { return effect->regressor_count(); }
    void reset(const fog::Signals<model::RealNumbers>& signals) { effect->reset(signals); }
    void step(const fog::Signals<model::RealNumbers>& signals, double* values) {
      effect->step(signals, values);
    }
  };
  return row_means([&](double block_s) { return Part{model::make_effect(term, block_s)}; }, reading,
                   model::follows_input_rate(term));
}

model::SignalRanges SignalSeries::signal_ranges() const {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  model::SignalRanges ranges;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    ranges[i] = {kInfinite, -kInfinite};
    for (const Run& run : runs_) {
      for (const Block& block : run.blocks) {
        const double value =
            model::value_of(static_cast<fog::Input>(i), block.signals, run.block_s);
        ranges[i] = {std::min(ranges[i].least, value), std::max(ranges[i].most, value)};
      }
    }
  }
  return ranges;
}

Eigen::MatrixXd SignalSeries::network_inputs(const std::vector<model::RealInput>& inputs) const {
  struct Part : model::NetworkSignals {
    using NetworkSignals::NetworkSignals;
    void step(const fog::Signals<model::RealNumbers>& signals, double* values) {
      const Eigen::VectorXd& now = NetworkSignals::step(signals);
      std::copy(now.begin(), now.end(), values);
    }
  };
  return row_means([&](double block_s) { return Part(inputs, block_s); });
}

}  // namespace fogcomp::series
