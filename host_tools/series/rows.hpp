#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/thermal/signals.hpp"
#include "model/real_numbers.hpp"
#include "recording/row_range.hpp"
#include "series/block_series.hpp"

namespace fogcomp::series {

/// What has one bias: the rows of a power-on, of a recording although the power was off in it, or
/// of all recordings. Where a recording is cut, each recording, and each part of a cut one.
enum class BiasOf { power_on, recording, all };

/// The rows that are fitted, compared and diagnosed: means over `average_s` of the blocks of one or
/// more recordings, or single blocks if these are longer.
struct Rows {
  Eigen::VectorXd drift_dph;  ///< measured rate - input rate
  Eigen::VectorXd seconds;    ///< that count, of each row
  Eigen::VectorXd weights;    ///< the same in full rows
  double row_s = 0;           ///< of a full row; the longest of all recordings
  double rounding_dph = 0;    ///< standard deviation of the rate's rounding in a full row
  std::vector<double> time_s;
  std::vector<fog::Signals<model::RealNumbers>> signals;  ///< means, with the board's delay
  std::vector<fog::BlockMeans<model::RealNumbers>>
      inputs;                           ///< means of the inputs in the row itself
  std::vector<std::size_t> run_starts;  ///< first row of each recording
  /// First row after each further power-on within a recording, in order.
  std::vector<std::size_t> restart_rows;
  /// First row after each cut, in order. The row in which a cut lies, and the nearer one of its
  /// neighbours, have a weight of 0: a time may be off by half a row.
  std::vector<std::size_t> cut_rows;
  BiasOf bias_of = BiasOf::power_on;
  model::InputRanges input_ranges{};  ///< of all recordings together

  Eigen::Index size() const { return drift_dph.size(); }
  /// The rows of each recording.
  std::vector<recording::RowRange> runs() const;
  /// The rows of each power-on.
  std::vector<recording::RowRange> power_ons() const;
  /// The rows that have one bias, by `bias_of`.
  std::vector<recording::RowRange> bias_ranges() const;
  /// One value per row, less the mean of each of these; `counted`: weights, 0 for excluded rows.
  Eigen::VectorXd about_biases(Eigen::VectorXd values, const Eigen::VectorXd& counted) const;
  /// Recording of a row, and whether the row is its first.
  std::size_t run_at(std::size_t row) const;
  bool starts_run(std::size_t row) const;
  /// Whether a row is the first after a cut.
  bool is_cut_at(std::size_t row) const;
  /// Whether a row directly follows the one before it: same recording, no gap.
  bool follows(std::size_t row) const;
  /// Rows without a gap.
  std::vector<recording::RowRange> stretches() const;
  /// From the first to the last row, of the longest recording.
  double longest_run_s() const;

  std::vector<double> temperatures_degc() const;  ///< measured in the row itself
  std::vector<double> temperature_rates_degc_per_min() const;
};

/// The part of a vector with one value per row.
template <class Vector>
auto of_rows(Vector& values, const recording::RowRange& range) {
  return values.segment(static_cast<Eigen::Index>(range.first),
                        static_cast<Eigen::Index>(range.size()));
}

/// Sum of the signals of some blocks.
class SignalSum {
 public:
  void add(double weight, const fog::Signals<model::RealNumbers>& signals);
  /// The input rate within the block is that of the last one.
  fog::Signals<model::RealNumbers> mean() const;

 private:
  double weight_ = 0;
  fog::Signals<model::RealNumbers> sum_{};
};

/// Averages the blocks of one recording to rows, appended to `rows`.
class RowAverager {
 public:
  /// `further`: number of additional values per block whose means are wanted.
  RowAverager(const BlockSeries& blocks, double average_s, Rows& rows, std::size_t further = 0);

  static constexpr std::int32_t kNoRow = -1;
  /// Adds a block, in order of time, with the board's signals at that time and `further` values.
  /// Returns its row; a masked block has none.
  std::int32_t take(const BlockSeries::Block& block,
                    const fog::Signals<model::RealNumbers>& signals,
                    const double* further = nullptr);
  /// Completes the last row. To be called once.
  void finish();
  /// Means of the additional values: one row per row of this recording.
  const Eigen::MatrixXd& further() const { return further_; }

 private:
  // Of the row that is not yet complete.
  struct Sum {
    double samples = 0;
    double time = 0;
    double drift = 0;
    SignalSum signals;
    fog::BlockMeans<model::RealNumbers> inputs;
  };

  void begin_row(std::int64_t number, double power_on_s);
  void complete_row();
  void cut(std::int64_t block);

  Rows& rows_;
  std::int64_t blocks_per_row_;
  double sample_s_;
  std::size_t first_row_;
  Sum sum_;
  std::vector<std::int64_t> numbers_;  // of the rows so far
  std::vector<double> drift_dph_;      // of the complete ones
  std::vector<double> seconds_;
  double power_on_s_ = 0;                // before the last row
  std::vector<std::int64_t> uncounted_;  // numbers of rows next to a cut
  std::optional<std::int64_t> cut_in_;   // row of a cut behind which no row has begun yet
  Eigen::Index further_values_;
  Eigen::MatrixXd further_;  // sums in the last row, until that is complete
};

/// At least one.
std::int64_t blocks_per_row(double average_s, double block_s);

/// Length of a row, seconds: a whole number of blocks.
double row_length_s(double average_s, double block_s);

/// First-order lag of `values` (one per row), stepped by the time between rows. Every recording
/// starts in the steady state at its first value.
Eigen::VectorXd first_order_lag(const Rows& rows, const Eigen::VectorXd& values, double tau_s);

/// The same once forward and once backward: smoother, without delay.
Eigen::VectorXd smoothed(const Rows& rows, const Eigen::VectorXd& values, double tau_s);

}  // namespace fogcomp::series
