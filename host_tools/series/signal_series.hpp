#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "model/model.hpp"
#include "series/block_series.hpp"
#include "series/rows.hpp"

namespace fogcomp::series {

/// How a temperature becomes the signals that effects see.
enum class Phase : std::uint8_t {
  board,  ///< by the board's own code, with its delays: what a compensation is fitted with
  zero,   ///< without delay (zero_phase.hpp): what a diagnosis looks at
};

/// Whose temperature the effects see.
enum class Reading : std::uint8_t {
  of_sensor,  ///< with the noise and the steps of the sensor, as the board has it
  smoothed,   ///< with little of them: through two more lags, forward and backward
};

/// What effects see over one or more recordings, kept so that an effect of any shape can be run
/// over it: signals block by block, and the row that each block is part of.
class SignalSeries {
 public:
  /// `model` gives the derivative's time constant and the averaging. Temperature is not clamped: a
  /// fit has no trained range yet.
  explicit SignalSeries(const model::Model& model, Phase phase = Phase::board)
      : model_(model), phase_(phase) {}

  /// Adds a recording. Throws InputError where it lacks a column that one of the model's effects
  /// needs.
  void add(const BlockSeries& series);

  const Rows& rows() const { return rows_; }

  /// The row means of an effect's regressors, rows x regressors of the effect. In Phase::zero both
  /// readings are one.
  Eigen::MatrixXd regressors(const model::EffectTerm& term,
                             Reading reading = Reading::of_sensor) const;
  Phase phase() const { return phase_; }
  /// The row means of what the terms make together with their coefficients, deg/h.
  Eigen::VectorXd drift_dph(const std::vector<model::EffectTerm>& terms) const;

  /// Min and max of each signal that an expression can have, over all blocks.
  model::SignalRanges signal_ranges() const;

  /// The row means of what a network would see, rows x inputs, in the inputs' units: what it is
  /// trained on. Normalisation is not used. The recordings must have what the inputs need, which
  /// add() has seen to where the model's network already lists them.
  Eigen::MatrixXd network_inputs(const std::vector<model::RealInput>& inputs) const;

 private:
  static constexpr std::int32_t kNoRow = RowAverager::kNoRow;
  using Signals = fog::Signals<model::RealNumbers>;
  // Blocks are what a long recording costs: of each only what cannot be had from the others.
  struct Seen {
    double temperature = 0;
    double temperature_rate = 0;
  };
  using Extension = decltype(fog::BlockMeans<model::RealNumbers>::extension);
  struct InputRate {
    double before_dph = 0;  ///< of the block that the signals are means of
    double dph = 0;         ///< while the signals hold
  };
  // The state of the thermal stage during one block.
  struct Block {
    Seen seen;
    double elapsed = 0;
    std::int32_t row = kNoRow;  // none where the board's drift is not valid, or masked
    std::uint32_t samples = 0;
  };
  struct Run {
    double block_s = 0;
    fog::InputMask inputs = 0;  ///< of the recording
    std::vector<Block> blocks;
    std::vector<bool> restarts;         ///< per block
    std::vector<InputRate> input_rate;  ///< per block; none where the recording has no such input
    std::vector<Extension> extension;   ///< the same
    std::vector<Seen> smoothed;         ///< per block; none in Phase::zero

    void keep(const Signals& signals, bool restart);
    Signals signals(std::size_t block, Reading reading) const;
    double input_rate_dph(std::size_t block) const;
  };
  template <class Keep>
  class Recorder;

  void add_as_the_board(const BlockSeries& series, RowAverager& rows);
  void add_without_delay(const BlockSeries& series, RowAverager& rows);
  // Row means of what make(block_s) gives block by block: an object with size(), reset(signals) and
  // step(signals, values). `follows_rate`: of what sees the input rate of the samples themselves.
  template <class Make>
  Eigen::MatrixXd row_means(const Make& make, Reading reading = Reading::of_sensor,
                            bool follows_rate = false) const;

  const model::Model& model_;
  Phase phase_;
  std::vector<Run> runs_;
  Rows rows_;
};

}  // namespace fogcomp::series
