#include "series/signal_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "model/catalogue.hpp"
#include "model/drift_model.hpp"
#include "model/input_value.hpp"
#include "model/shape_parameter.hpp"
#include "recording/decision_rules.hpp"
#include "series/block_walk.hpp"
#include "series/term_columns.hpp"
#include "support/input_error.hpp"
#include "support/parallel.hpp"

namespace fogcomp::series {
namespace {

// What the board makes of the temperature itself. Only temperatures are kept: the blocks need much
// more memory.
template <class DriftModel>
void run_without_noise(const BlockSeries& series, const MeasuredTemperature& own,
                       DriftModel& model) {
  const auto means_with = [&](fog::BlockMeans<model::RealNumbers> means, std::int64_t number) {
    means.temperature = own.at(number).degc;
    return means;
  };
  const auto means_of = [&](std::size_t i) {
    return means_with(series.blocks[i].means, series.blocks[i].number);
  };
  run_blocks(series, means_with(series.first, series.blocks[0].number), means_of, model,
             [](const BlockSeries::Block&) {});
}

// Of the gyro's drift by each unknown, in the order of the covariance.
Eigen::MatrixXd unknown_columns(const model::Model& model, const SignalSeries& series) {
  std::vector<model::EffectTerm> terms;
  for (const model::EffectTerm& term : model.terms) {
    if (!model::is_found_event(term)) terms.push_back(model::of_gyro(term));
  }
  const std::vector<model::ShapeParameter> shapes = model::shape_parameters(terms);
  const std::vector<ColumnRange> ranges = columns_of(terms, series.rows().row_s);
  Eigen::MatrixXd columns(series.rows().size(), model::unknowns_of(model));
  for (std::size_t i = 0; i < terms.size(); ++i) {
    columns.middleCols(ranges[i].first, ranges[i].count) =
        series.regressors(terms[i], Reading::of_gyro);
  }
  Eigen::Index at = ranges.back().first + ranges.back().count;
  for (const model::ShapeParameter& shape : shapes) {
    const model::EffectTerm& term = terms[shape.term];
    const auto drift_of = [&](const model::EffectTerm& moved) -> Eigen::VectorXd {
      return series.regressors(moved, Reading::of_gyro) * term.coefficients();
    };
    columns.col(at++) = model::derivative_by_unit(shape, term, drift_of) /
                        shape.slope(term.parameters[shape.index].value);
  }
  return columns;
}

std::string remedy(fog::Input input) {
  switch (input) {
    case fog::Input::elapsed:
      return "time_s must be seconds since power-on and begins below 0 here";
    case fog::Input::input_rate:
      return "add it, give --latitude, or leave the effect out";
    default:
      return "add it, or leave the effect out";
  }
}

void require(const std::string& who, fog::InputMask needs, const BlockSeries& series) {
  for (const fog::InputDescription& input : fog::kInputTable) {
    if (!has(needs & ~series.inputs, input.input)) continue;
    throw InputError(series.file,
                     who + " needs the column " + input.column + "; " + remedy(input.input));
  }
}

}  // namespace

void SignalSeries::Track::keep(const Signals& signals, bool restart) {
  const fog::BlockMeans<model::RealNumbers>& means = signals.block;
  blocks.push_back({{signals.temperature, signals.temperature_rate}, means.elapsed, kNoRow, 0});
  if (restart) restarts.push_back(blocks.size() - 1);
  if (means.power_on.at != 0 || !power_on.empty()) {
    power_on.resize(blocks.size() - 1);
    power_on.push_back(means.power_on);
  }
  if (has(inputs, fog::Input::input_rate)) {
    input_rate.push_back({means.input_rate, means.input_rate, means.rate_within});
  }
  if ((inputs & fog::kAllExtensionInputs) != 0) extension.push_back(means.extension);
}

// The unclamped temperature of the signals is that of their block. `signals`: of an earlier block
// of the track or new.
void SignalSeries::Track::read(std::size_t block, const Seen& seen, Signals& signals) const {
  signals.temperature = seen.temperature;
  signals.temperature_rate = seen.temperature_rate;
  signals.block.temperature = signals.temperature;
  if (!input_rate.empty()) {
    signals.block.input_rate = input_rate[block].before_dph;
    signals.block.rate_within = input_rate[block].within;
  }
  signals.block.elapsed = blocks[block].elapsed;
  if (!power_on.empty()) signals.block.power_on = power_on[block];
  if (!extension.empty()) signals.block.extension = extension[block];
}

SignalSeries::Signals SignalSeries::Track::signals(std::size_t block) const {
  Signals signals{};
  read(block, blocks[block].seen, signals);
  return signals;
}

void SignalSeries::Run::read(std::size_t block, Reading reading, const TemperatureChange& change,
                             Signals& signals) const {
  const Track& own = track(reading);
  const bool is_delayed = reading == Reading::without_noise && !delayed.empty();
  Seen seen = is_delayed ? delayed[block] : own.blocks[block].seen;
  seen.temperature += change.degc;
  seen.temperature_rate += change.degc_per_min;
  own.read(block, seen, signals);
}

// Column by column: adding each block's values as soon as they are stored would wait for the store.
void SignalSeries::Track::add(std::size_t first, std::size_t count, const double* values,
                              Eigen::MatrixXd& sums) const {
  const auto size = static_cast<std::size_t>(sums.cols());
  for (std::size_t k = 0; k < size; ++k) {
    double* const sum = sums.col(static_cast<Eigen::Index>(k)).data();
    for (std::size_t i = 0; i < count; ++i) {
      const Block& block = blocks[first + i];
      if (block.row != kNoRow) sum[block.row] += block.samples * values[size * i + k];
    }
  }
}

// Stands for the drift model in run_blocks and passes its inputs to keep(signals, whether the
// model restarts).
template <class Keep>
class SignalSeries::Recorder {
 public:
  Recorder(const model::Model& model, double block_s, Keep keep)
      : thermal_(unclamped(model::thermal_parameters(model, block_s))), keep_(std::move(keep)) {}

  void start(const model::RealBlock& block) { keep_(thermal_.reset(block), true); }
  void step(const model::RealBlock& block) { keep_(thermal_.step(block), false); }
  void see_rate(const model::RealBlock&) {}
  void forget() {}

 private:
  static fog::ThermalParameters<model::RealNumbers> unclamped(
      fog::ThermalParameters<model::RealNumbers> p) {
    p.min = -std::numeric_limits<double>::infinity();
    p.max = std::numeric_limits<double>::infinity();
    return p;
  }

  fog::ThermalState<model::RealNumbers> thermal_;
  Keep keep_;
};

void SignalSeries::add(const BlockSeries& series) {
  require_inputs(model_, series);
  Run& run = runs_.emplace_back();
  run.block_s = series.block_s;
  run.is_table = series.is_table;
  run.recordings = series.recordings;
  run.rates_within = series.input_rates;
  const std::shared_ptr<const MeasuredTemperature> own = temperature_of(series);
  see_thermometer(own->thermometer);
  RowAverager rows(series, model_.average_s, rows_);
  const std::vector<std::int32_t> row_of = phase_ == Phase::board
                                               ? add_as_the_board(series, *own, rows)
                                               : add_without_delay(series, *own, rows);
  rows.finish();
  keep_own(series, *own, row_of, run.gyro);
  samples_.conservativeResizeLike(Eigen::VectorXd::Zero(rows_.size()));
  settled_.conservativeResizeLike(Eigen::VectorXd::Ones(rows_.size()));
  if (phase_ == Phase::board) see_ramps_at_start(series, *own, row_of);
  for (const Block& block : run.gyro.blocks) {
    if (block.row != kNoRow) samples_[block.row] += block.samples;
  }
}

std::vector<std::int32_t> SignalSeries::add_as_the_board(const BlockSeries& series,
                                                         const MeasuredTemperature& own,
                                                         RowAverager& rows) {
  Run& run = runs_.back();
  Track& board = run.board;
  board.block_s = series.block_s;
  board.inputs = series.inputs;
  board.blocks.reserve(series.blocks.size() + 1);
  run.delayed.reserve(series.blocks.size() + 1);
  Recorder delayed_recorder(model_, series.block_s, [&](const Signals& signals, bool) {
    run.delayed.push_back({signals.temperature, signals.temperature_rate});
  });
  run_without_noise(series, own, delayed_recorder);
  std::vector<std::int32_t> row_of(series.blocks.size(), kNoRow);
  Recorder recorder(model_, series.block_s,
                    [&](const Signals& signals, bool restart) { board.keep(signals, restart); });
  run_blocks(series, recorder, [&](const BlockSeries::Block& block) {
    Block& current = board.blocks.back();
    if (!board.input_rate.empty()) {
      board.input_rate.back().dph = block.means.input_rate;
      board.input_rate.back().within = block.means.rate_within;
    }
    current.row = rows.take(block, board.signals(board.blocks.size() - 1));
    current.samples = block.samples;
    row_of[static_cast<std::size_t>(&block - series.blocks.data())] = current.row;
  });
  return row_of;
}

std::vector<std::int32_t> SignalSeries::add_without_delay(const BlockSeries& series,
                                                          const MeasuredTemperature& own,
                                                          RowAverager& rows) {
  std::vector<std::int32_t> row_of;
  for (const BlockSeries::Block& block : series.blocks) {
    const TemperatureNow& now = own.at(block.number);
    row_of.push_back(rows.take(block, {now.degc, now.degc_per_min, block.means}));
  }
  return row_of;
}

namespace {

// Of the lags of dT/dt that an effect of the catalogue may have: 5 s. Over blocks as long a lag of
// 20 s is wrong by 0.5 %.
double shortest_lag_s() {
  double shortest_s = HUGE_VAL;
  for (const model::CatalogueEntry& entry : model::catalogue()) {
    for (const fog::ParameterDescription& parameter : entry.parameters) {
      if (parameter.time != fog::Time::constant_of_rate) continue;
      shortest_s = std::min(shortest_s, parameter.min_milli / 1000.0);
    }
  }
  return shortest_s;
}

// How many blocks are one for the gyro's own signals: part of a row of the model. An input rate may
// differ from sample to sample.
std::int64_t blocks_together(const BlockSeries& series, double average_s) {
  if (has(series.inputs, fog::Input::input_rate)) return 1;
  const std::int64_t in_row = blocks_per_row(average_s, series.block_s);
  const auto most = static_cast<std::int64_t>(shortest_lag_s() / series.block_s);
  std::int64_t together = std::clamp<std::int64_t>(most, 1, in_row);
  while (in_row % together != 0) --together;
  return together;
}

// Times are counted in blocks.
fog::Signals<model::RealNumbers> in_blocks_of(double together,
                                              fog::Signals<model::RealNumbers> signals) {
  fog::BlockMeans<model::RealNumbers>& block = signals.block;
  for (double* const time :
       {&block.elapsed, &block.power_on.at, &block.power_on.was_on, &block.power_on.was_off}) {
    *time /= together;
  }
  return signals;
}

}  // namespace

// A block that is missing keeps the inputs of the one before it.
void SignalSeries::keep_own(const BlockSeries& series, const MeasuredTemperature& own,
                            const std::vector<std::int32_t>& row_of, Track& gyro) const {
  const std::int64_t together = blocks_together(series, model_.average_s);
  gyro.block_s = static_cast<double>(together) * series.block_s;
  gyro.inputs = series.inputs;
  each_part(series, [&](std::size_t first, std::size_t end) {
    SignalSum sum;
    Block counted;
    bool is_first = true;
    fog::BlockMeans<model::RealNumbers> means;
    for (std::int64_t number = series.blocks[first].number; first < end; ++number) {
      const BlockSeries::Block& block = series.blocks[first];
      means.elapsed += 1;
      if (block.number == number) {
        means = block.means;
        if (row_of[first] != kNoRow) {
          counted.row = row_of[first];
          counted.samples += block.samples;
        }
        ++first;
      }
      const TemperatureNow& now = own.at(number);
      sum.add(1, {now.degc, now.degc_per_min, means});
      if ((number + 1) % together != 0 && first < end) continue;
      gyro.keep(in_blocks_of(static_cast<double>(together), std::exchange(sum, {}).mean()),
                std::exchange(is_first, false));
      gyro.blocks.back().row = counted.row;
      gyro.blocks.back().samples = std::exchange(counted, {}).samples;
    }
  });
}

void SignalSeries::see_ramps_at_start(const BlockSeries& series, const MeasuredTemperature& own,
                                      const std::vector<std::int32_t>& row_of) {
  const double settling = settling_s() / series.block_s;
  each_part(series, [&](std::size_t first, std::size_t end) {
    const std::int64_t start = series.blocks[first].number;
    if (std::abs(own.at(start).degc_per_min) <= recording::rules::kMinRampDegcPerMin) return;
    for (std::size_t i = first; i < end; ++i) {
      if (static_cast<double>(series.blocks[i].number - start) >= settling) return;
      if (row_of[i] != kNoRow) settled_[row_of[i]] = 0;
    }
  });
}

void SignalSeries::see_thermometer(const Thermometer& thermometer) {
  if (thermometer.white_degc2_s > thermometer_.white_degc2_s) thermometer_ = thermometer;
}

namespace {

// What lags begin with. The board knows no rate of temperature at its start; a lag that begins with
// the rate of a ramp would differ from the board's for as long as its time constant.
fog::Signals<model::RealNumbers> at_rest(fog::Signals<model::RealNumbers> signals) {
  signals.temperature_rate = 0;
  return signals;
}

}  // namespace

template <class Make>
Eigen::MatrixXd SignalSeries::row_means(const Make& make, Reading reading, bool follows_rate,
                                        const TemperatureChange& change) const {
  constexpr std::size_t kTogether = 64;
  const std::size_t size = make(runs_.front()).size();
  Eigen::MatrixXd means = Eigen::MatrixXd::Zero(rows_.size(), static_cast<Eigen::Index>(size));
  for_each_index(runs_.size(), [&](std::size_t number) {
    const Run& run = runs_[number];
    const Track& track = run.track(reading);
    std::vector<Signals> signals(kTogether);
    std::vector<double> values(size * kTogether);
    const auto read = [&](std::size_t block, Signals& now) {
      run.read(block, reading, change, now);
      if (follows_rate && !track.input_rate.empty()) {
        now.block.input_rate = track.input_rate[block].dph;
      }
    };
    std::optional part(make(run));
    for (const recording::RowRange& stretch :
         recording::ranges_from(track.restarts, track.blocks.size())) {
      if (run.is_table) part.emplace(make(run));
      read(stretch.first, signals[0]);
      part->reset(at_rest(signals[0]));
      for (std::size_t first = stretch.first; first < stretch.end; first += kTogether) {
        const std::size_t count = std::min(kTogether, stretch.end - first);
        for (std::size_t i = 0; i < count; ++i) read(first + i, signals[i]);
        part->run(signals.data(), count, values.data());
        track.add(first, count, values.data(), means);
      }
    }
  });
  means.array().colwise() *= samples_.array().inverse();
  return means;
}

Eigen::VectorXd SignalSeries::drift_dph(const std::vector<model::EffectTerm>& terms,
                                        Reading reading) const {
  Eigen::VectorXd drift = Eigen::VectorXd::Zero(rows_.size());
  for (const model::EffectTerm& own : terms) {
    const model::EffectTerm term = reading == Reading::of_gyro ? model::of_gyro(own) : own;
    drift += regressors(term, reading) * term.coefficients();
  }
  return drift;
}

std::vector<model::EffectTerm> SignalSeries::acting(std::vector<model::EffectTerm> terms) const {
  const auto acts_on_none = [&](const model::EffectTerm& term) {
    return std::none_of(runs_.begin(), runs_.end(),
                        [&](const Run& run) { return term.acts_on(run.recordings); });
  };
  terms.erase(std::remove_if(terms.begin(), terms.end(), acts_on_none), terms.end());
  return terms;
}

std::optional<std::uint64_t> SignalSeries::recording_of(std::size_t row) const {
  const std::vector<std::uint64_t>& recordings = runs_[rows_.run_at(row)].recordings;
  if (recordings.empty()) return std::nullopt;
  return recordings.front();
}

Eigen::MatrixXd SignalSeries::regressors(const model::EffectTerm& term, Reading reading,
                                         const TemperatureChange& change) const {
  struct Part {
    std::unique_ptr<model::RealEffect> effect;
    std::size_t size() const { return effect->regressor_count(); }
    void reset(const fog::Signals<model::RealNumbers>& signals) { effect->reset(signals); }
    void run(const fog::Signals<model::RealNumbers>* signals, std::size_t count, double* values) {
      effect->run(signals, count, values);
    }
  };
  const auto part = [&](const Run& run) {
    const Track& track = run.track(reading);
    return Part{model::make_effect(
        &track == &run.board ? term : model::for_present_block(term, run.block_s), track.block_s)};
  };
  Eigen::MatrixXd means = row_means(part, reading, model::follows_input_rate(term), change);
  const std::vector<recording::RowRange> runs = rows_.runs();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    auto of_run = means.middleRows(static_cast<Eigen::Index>(runs[i].first),
                                   static_cast<Eigen::Index>(runs[i].size()));
    if (!term.acts_on(runs_[i].recordings)) {
      of_run.setZero();
    } else if (term.others_part > 0) {
      of_run.array() -= term.others_part;
    }
  }
  return means;
}

model::SignalRanges SignalSeries::signal_ranges() const {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  model::SignalRanges ranges;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    ranges[i] = {kInfinite, -kInfinite};
    for (const Run& run : runs_) {
      const Track& track = run.track(Reading::of_sensor);
      for (std::size_t block = 0; block < track.blocks.size(); ++block) {
        const double value =
            model::value_of(static_cast<fog::Input>(i), track.signals(block), track.block_s);
        ranges[i] = {std::min(ranges[i].min, value), std::max(ranges[i].max, value)};
      }
    }
  }
  return ranges;
}

Eigen::MatrixXd SignalSeries::network_inputs(const std::vector<model::RealInput>& inputs) const {
  struct Part : model::NetworkSignals {
    using NetworkSignals::NetworkSignals;
    void run(const fog::Signals<model::RealNumbers>* signals, std::size_t count, double* values) {
      for (std::size_t i = 0; i < count; ++i) {
        const Eigen::VectorXd& now = step(signals[i]);
        values = std::copy(now.begin(), now.end(), values);
      }
    }
  };
  return row_means(
      [&](const Run& run) { return Part(inputs, run.track(Reading::of_sensor).block_s); });
}

Eigen::VectorXd drift_sigma_dph(const model::Model& model, const SignalSeries& series) {
  const Eigen::MatrixXd columns = unknown_columns(model, series);
  const Eigen::VectorXd of_delay =
      series.drift_dph(model.terms) - series.drift_dph(model.terms, Reading::of_gyro);
  const Eigen::VectorXd variance =
      (columns * model.uncertainty->covariance).cwiseProduct(columns).rowwise().sum();
  return (variance.cwiseMax(0) + of_delay.cwiseAbs2()).cwiseSqrt();
}

void require_inputs(const std::vector<model::EffectTerm>& terms, const BlockSeries& series) {
  for (const model::EffectTerm& term : terms) {
    require(term.name, model::info_of(term).needs, series);
  }
}

void require_inputs(const model::Model& model, const BlockSeries& series) {
  require_inputs(model.terms, series);
  require("the network", model.network.needs(), series);
}

}  // namespace fogcomp::series
