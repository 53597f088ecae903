#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/model.hpp"
#include "series/block_series.hpp"
#include "series/measured_temperature.hpp"
#include "series/rows.hpp"

namespace fogcomp::series {

/// Computation of the effects' signals from the temperature.
enum class Phase : std::uint8_t {
  board,  ///< by the board's own code, with its delays: for fitting a compensation
  zero,   ///< without delay: the gyro's own temperature, for a diagnosis
};

/// Temperature used by the effects.
enum class Reading : std::uint8_t {
  of_sensor,      ///< with noise, steps and the derivative's delay, like the board
  without_noise,  ///< with the delay, but of the temperature itself (measured_temperature.hpp)
  of_gyro,        ///< without the delay: the gyro's own temperature and its rate
};

/// A change of the gyro's own temperature, to see what a drift makes of it.
struct TemperatureChange {
  double degc = 0;
  double degc_per_min = 0;
};

/// Inputs of effects over one or more recordings, stored so that an effect of any shape can be run
/// over them: signals block by block, and the row of each block.
class SignalSeries {
 public:
  /// `model` defines the derivative's time constant and the averaging. Temperature is not clamped,
  /// because a fit has no trained range yet.
  explicit SignalSeries(const model::Model& model, Phase phase = Phase::board)
      : model_(model), phase_(phase) {}

  /// Adds a recording. Throws InputError if it lacks a column that one of the model's effects
  /// needs.
  void add(const BlockSeries& series);

  const Rows& rows() const { return rows_; }
  /// Time in which the board's derivative forgets that it began at rest: less than 1 % is left.
  double settling_s() const { return 5 * model_.derivative_tau_s; }
  /// 1 in each row; 0 in those in which the board's derivative forgets that it began at rest, in a
  /// ramp: after a power-on, or a gap that is not bridged. As a board flags them.
  const Eigen::VectorXd& settled() const { return settled_; }
  /// What has one bias in Rows::bias_ranges(); at first each power-on.
  void share_bias(BiasOf of) { rows_.bias_of = of; }
  /// Those of the terms that act on one of the runs: not the events of other recordings.
  std::vector<model::EffectTerm> acting(std::vector<model::EffectTerm> terms) const;
  /// The first of BlockSeries::recordings of a row's run; nothing if there is none.
  std::optional<std::uint64_t> recording_of(std::size_t row) const;

  /// Row means of an effect's regressors, rows x regressors; 0 in runs on which an event does not
  /// act, less EffectTerm::others_part in its own. In Phase::zero all readings are the same.
  /// `change`: of the temperature that is read.
  Eigen::MatrixXd regressors(const model::EffectTerm& term, Reading reading = Reading::of_sensor,
                             const TemperatureChange& change = {}) const;
  /// Of the recording whose temperature is known worst.
  const Thermometer& thermometer() const { return thermometer_; }
  Phase phase() const { return phase_; }
  /// Row means of the terms' drift, deg/h, with their coefficients or the gyro's own.
  Eigen::VectorXd drift_dph(const std::vector<model::EffectTerm>& terms,
                            Reading reading = Reading::of_sensor) const;

  /// Min and max of each signal available to an expression, over all blocks.
  model::SignalRanges signal_ranges() const;

  /// Row means of network inputs, rows x inputs, in their units, without normalisation: training
  /// data. The recordings must have the inputs; add() has checked those of the model's own network.
  Eigen::MatrixXd network_inputs(const std::vector<model::RealInput>& inputs) const;

 private:
  static constexpr std::int32_t kNoRow = RowAverager::kNoRow;
  using Signals = fog::Signals<model::RealNumbers>;
  // Blocks dominate the memory of a long recording: each stores only what cannot be derived from
  // the others.
  struct Seen {
    double temperature = 0;
    double temperature_rate = 0;
  };
  using Extension = decltype(fog::BlockMeans<model::RealNumbers>::extension);
  using PowerOn = model::RealNumbers::PowerOn;
  struct InputRate {
    double before_dph = 0;                  ///< of the block whose means the signals are
    double dph = 0;                         ///< in the block in which the signals are used
    model::RealNumbers::RateWithin within;  ///< in that block
  };
  // State of the thermal stage during one block.
  struct Block {
    Seen seen;
    double elapsed = 0;
    std::int32_t row = kNoRow;  // kNoRow if the board's drift is invalid, or the block is masked
    std::uint32_t samples = 0;
  };
  // What effects are run over.
  struct Track {
    double block_s = 0;
    fog::InputMask inputs = 0;  ///< of the recording
    std::vector<Block> blocks;
    std::vector<std::size_t> restarts;  ///< blocks before which the model begins anew
    std::vector<PowerOn> power_on;      ///< per block; empty if it is time 0 for all
    std::vector<InputRate> input_rate;  ///< per block; empty if the recording lacks it
    std::vector<Extension> extension;   ///< the same

    void keep(const Signals& signals, bool restart);
    void read(std::size_t block, const Seen& seen, Signals& signals) const;
    Signals signals(std::size_t block) const;
    /// Adds what the blocks from `first` on add to row sums; `values`: of each, columns of `sums`.
    void add(std::size_t first, std::size_t count, const double* values,
             Eigen::MatrixXd& sums) const;
  };
  struct Run {
    double block_s = 0;  ///< of the board
    bool is_table = false;
    std::vector<std::uint64_t> recordings;
    Track board;                                      ///< empty in Phase::zero
    std::vector<Seen> delayed;                        ///< without noise, of each of these blocks
    Track gyro;                                       ///< its own temperature, without delay
    decltype(BlockSeries::input_rates) rates_within;  ///< owners of what `input_rate` points to

    const Track& track(Reading reading) const {
      return reading == Reading::of_gyro || board.blocks.empty() ? gyro : board;
    }
    void read(std::size_t block, Reading reading, const TemperatureChange& change,
              Signals& signals) const;
  };
  template <class Keep>
  class Recorder;

  // Both return the row of each block.
  std::vector<std::int32_t> add_as_the_board(const BlockSeries& series,
                                             const MeasuredTemperature& own, RowAverager& rows);
  static std::vector<std::int32_t> add_without_delay(const BlockSeries& series,
                                                     const MeasuredTemperature& own,
                                                     RowAverager& rows);
  void see_ramps_at_start(const BlockSeries& series, const MeasuredTemperature& own,
                          const std::vector<std::int32_t>& row_of);
  void keep_own(const BlockSeries& series, const MeasuredTemperature& own,
                const std::vector<std::int32_t>& row_of, Track& gyro) const;
  void see_thermometer(const Thermometer& thermometer);
  // Row means of make(run): an object with size(), reset(signals) and run(signals, count,
  // values), block by block. `follows_rate`: for effects of the samples' own input rate.
  template <class Make>
  Eigen::MatrixXd row_means(const Make& make, Reading reading = Reading::of_sensor,
                            bool follows_rate = false, const TemperatureChange& change = {}) const;

  model::Model model_;
  Phase phase_;
  std::vector<Run> runs_;
  Rows rows_;
  Eigen::VectorXd samples_;  // of each row
  Eigen::VectorXd settled_;
  Thermometer thermometer_;
};

/// Standard deviation of the drift that a board subtracts in each row, deg/h: of coefficients and
/// shapes, and what the delay of its derivative changes; without the noise of the rate. Requires
/// Model::uncertainty; `series`: in Phase::board.
Eigen::VectorXd drift_sigma_dph(const model::Model& model, const SignalSeries& series);

/// Throws InputError with file, column and effect if a recording lacks an input of a term. To be
/// called before a model is run over a recording: missing columns would be zeros.
void require_inputs(const std::vector<model::EffectTerm>& terms, const BlockSeries& series);
/// The same, including the network.
void require_inputs(const model::Model& model, const BlockSeries& series);

}  // namespace fogcomp::series
