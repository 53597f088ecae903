#include "workflow/apply.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "model/drift_model.hpp"
#include "model/model_file.hpp"
#include "recording/columns.hpp"
#include "series/block_walk.hpp"
#include "series/signal_series.hpp"
#include "workflow/reading.hpp"

namespace fogcomp::workflow {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
constexpr int kRateDecimals = 6;
constexpr int kBoardRateDecimals = 10;  // exact for multiples of 1/1024
const char* const kDrift = "drift_dph";
const char* const kCompensated = "compensated_dph";
const char* const kSigma = "sigma_dph";

SeriesSink::Column column(recording::Column column) {
  const recording::ColumnInfo& info = recording::column_info(column);
  return {std::string(info.name), info.decimals};
}

/// Running standard deviation (Welford).
class Scatter {
 public:
  void add(double value) {
    ++count_;
    const double from_mean = value - mean_;
    mean_ += from_mean / count_;
    squares_ += from_mean * (value - mean_);
  }
  double std() const { return count_ > 1 ? std::sqrt(squares_ / (count_ - 1)) : 0; }

 private:
  double count_ = 0;
  double mean_ = 0;
  double squares_ = 0;
};

/// Passes rows on and counts them.
class RowsOut {
 public:
  explicit RowsOut(const SeriesSink& sink) : sink_(sink) {}

  void begin(const std::vector<SeriesSink::Column>& columns) const {
    if (sink_.begin) sink_.begin(columns);
  }
  // Whether a row has a rate, and one that counts: in a mask it tells nothing about the model.
  enum class Rate { counts, masked, none };
  void add(const std::vector<double>& values, fog::Status flags, Rate rate, double raw_dph,
           double compensated_dph) {
    if (sink_.row) sink_.row(values, flags);
    ++outcome_.rows;
    if (has_any(flags, fog::Status::temperature_clamped)) ++outcome_.clamped;
    if (rate == Rate::none) ++outcome_.without_rate;
    if (rate != Rate::counts) return;
    raw_.add(raw_dph);
    compensated_.add(compensated_dph);
  }
  ApplyOutcome finish() {
    outcome_.raw_std_dph = raw_.std();
    outcome_.compensated_std_dph = compensated_.std();
    return outcome_;
  }

 private:
  const SeriesSink& sink_;
  ApplyOutcome outcome_;
  Scatter raw_;
  Scatter compensated_;
};

/// The drift model in double, run over a recording; its rows by their blocks.
class RealSeries {
 public:
  RealSeries(const model::Model& model, const recording::Recording& recording, RowsOut& out)
      : model_(model),
        recording_(recording),
        out_(out),
        follows_rate_(
            std::any_of(model.terms.begin(), model.terms.end(), model::follows_input_rate)) {}

  void run() {
    const series::BlockSeries blocks = series::make_blocks(recording_);
    series::require_inputs(model_, blocks);
    samples_per_block_ = blocks.samples_per_block;
    begin();
    const model::Model acting = model::as_it_acts_on(model_, blocks.recordings);
    if (model_.uncertainty) sigma_dph_ = sigma_of(blocks);
    model::RealDriftModel drift(acting, blocks.block_s);
    series::run_blocks(blocks, drift, [&](const series::BlockSeries::Block& block) {
      rows_before(block.number);
      rows_of(block, drift);
      ++drifts_;
    });
    rows_before(std::numeric_limits<std::int64_t>::max());
  }

 private:
  void begin() const {
    std::vector<SeriesSink::Column> columns{column(recording::Column::time_s),
                                            column(recording::Column::temperature_degc),
                                            column(recording::Column::rate_dph)};
    if (has_input()) columns.push_back(column(recording::Column::input_rate_dph));
    for (const model::EffectTerm& term : model_.terms) {
      columns.push_back({"drift_" + term.name + "_dph", kRateDecimals});
    }
    if (model_.network.present()) columns.push_back({"drift_network_dph", kRateDecimals});
    columns.push_back({kDrift, kRateDecimals});
    columns.push_back({kCompensated, kRateDecimals});
    if (model_.uncertainty) columns.push_back({kSigma, kRateDecimals});
    out_.begin(columns);
  }

  // Of each block with a drift; one that is masked has a drift like any other.
  Eigen::VectorXd sigma_of(series::BlockSeries blocks) const {
    for (series::BlockSeries::Block& block : blocks.blocks) block.masked = false;
    model::Model single = model_;
    single.average_s = blocks.block_s;
    series::SignalSeries series(single);
    series.add(blocks);
    return series::drift_sigma_dph(model_, series);
  }

  bool has_input() const { return !recording_.input_rate_dph.empty(); }
  std::int64_t block_of(std::size_t row) const {
    return series::sample_number(recording_, row) / samples_per_block_;
  }

  // After a gap longer than the board holds its drift, there is no drift.
  void rows_before(std::int64_t block) {
    for (; row_ < recording_.rows() && block_of(row_) < block; ++row_) {
      std::vector<double> values = measured();
      values.insert(values.end(), parts() + (model_.uncertainty ? 3 : 2), kNoValue);
      out_.add(values, fog::Status::drift_given_up, RowsOut::Rate::none, 0, 0);
    }
  }

  // The effects that follow the input rate act on each sample's own.
  void rows_of(const series::BlockSeries::Block& block, model::RealDriftModel& drift) {
    const bool clamped =
        block.means.temperature < model_.min_degc || block.means.temperature > model_.max_degc;
    const fog::Status flags = status_if(clamped, fog::Status::temperature_clamped);
    for (; row_ < recording_.rows() && block_of(row_) == block.number; ++row_) {
      if (follows_rate_) drift.see_rate(inputs_of_row(block));
      std::vector<double> values = measured();
      for (std::size_t term = 0; term < model_.terms.size(); ++term) {
        values.push_back(drift.effect_dph(term));
      }
      if (model_.network.present()) values.push_back(drift.network_dph());
      const double rate_dph = recording_.rate_dph[row_];
      const double input_dph = has_input() ? recording_.input_rate_dph[row_] : 0;
      const double compensated_dph = rate_dph - drift.drift_dph();
      values.push_back(drift.drift_dph());
      values.push_back(compensated_dph);
      if (model_.uncertainty) values.push_back(sigma_dph_[drifts_]);
      out_.add(values, flags, block.masked ? RowsOut::Rate::masked : RowsOut::Rate::counts,
               rate_dph - input_dph, compensated_dph - input_dph);
    }
  }

  // The rise is that of a whole block, as the effects take it.
  model::RealBlock inputs_of_row(const series::BlockSeries::Block& block) const {
    model::RealBlock inputs = block.means;
    inputs.input_rate = recording_.input_rate_dph[row_];
    inputs.rate_within = series::rise_of_input_rate(recording_, row_, 1, samples_per_block_);
    return inputs;
  }

  std::vector<double> measured() const {
    std::vector<double> values{recording_.time_s[row_], recording_.temperature_degc[row_],
                               recording_.rate_dph[row_]};
    if (has_input()) values.push_back(recording_.input_rate_dph[row_]);
    return values;
  }
  std::size_t parts() const { return model_.terms.size() + (model_.network.present() ? 1 : 0); }

  const model::Model& model_;
  const recording::Recording& recording_;
  RowsOut& out_;
  bool follows_rate_;
  std::uint32_t samples_per_block_ = 1;
  std::size_t row_ = 0;
  Eigen::VectorXd sigma_dph_;
  Eigen::Index drifts_ = 0;  // blocks so far
};

/// The board's samples one by one; those of a capture have their time from their numbers.
class BoardSeries {
 public:
  BoardSeries(RowsOut& out, double capture_rate_hz) : out_(out), rate_hz_(capture_rate_hz) {
    out_.begin({column(recording::Column::time_s),
                column(recording::Column::temperature_degc),
                {std::string(recording::column_info(recording::Column::rate_dph).name),
                 kBoardRateDecimals},
                {kDrift, kBoardRateDecimals},
                {kCompensated, kBoardRateDecimals},
                {"denoised_dph", kBoardRateDecimals}});
  }

  void feed(board::Replay& board, const board::StreamSource& source,
            fog::Span<const std::uint8_t> bytes, fog::SampleTime time) {
    for (std::size_t i = 0; i < bytes.size; ++i) {
      if (board.feed({bytes.data + i, 1}, time).size > 0) take(board.last(), source);
    }
  }

 private:
  void take(const fog::OutputSample& sample, const board::StreamSource& source) {
    const auto step = static_cast<std::int16_t>(sample.sequence - sequence_);
    number_ = row_ == 0 ? sample.sequence : number_ + step;
    sequence_ = sample.sequence;
    const double time_s =
        source.is_capture() ? static_cast<double>(number_) / rate_hz_ : source.time_s()[row_];
    ++row_;
    const auto dph = [](fog::Rate rate) {
      return std::ldexp(rate.raw(), -fog::Rate::fractional_bits);
    };
    const double degc = std::ldexp(sample.temperature.raw(), -fog::Temperature::fractional_bits);
    const double compensated_dph = dph(sample.compensated);
    const double rate_dph = compensated_dph + dph(sample.drift);
    out_.add({time_s, degc, rate_dph, dph(sample.drift), compensated_dph, dph(sample.denoised)},
             sample.status,
             sample.compensated_valid() ? RowsOut::Rate::counts : RowsOut::Rate::none, rate_dph,
             compensated_dph);
  }

  RowsOut& out_;
  double rate_hz_;
  std::size_t row_ = 0;
  std::uint16_t sequence_ = 0;
  std::int64_t number_ = 0;
};

}  // namespace

ApplyOutcome apply(const ApplyRequest& request, const SeriesSink& sink, const Observer& observer) {
  RowsOut out(sink);
  if (request.on_board) {
    BoardSeries series(out,
                       request.reading.stream_rate_hz.value_or(recording::kDefaultStreamRateHz));
    run_board(
        request,
        [&](board::Replay& board, const board::StreamSource& source,
            fog::Span<const std::uint8_t> bytes,
            fog::SampleTime time) { series.feed(board, source, bytes, time); },
        observer);
    return out.finish();
  }
  const model::Model model = model::load_model(request.weights);
  recording::ReadOptions reading = reading_for(model, request.reading, observer);
  reading.every_row = true;
  const recording::Recording recording = recording::read_recording(request.run, reading);
  RealSeries(model, recording, out).run();
  return out.finish();
}

}  // namespace fogcomp::workflow
