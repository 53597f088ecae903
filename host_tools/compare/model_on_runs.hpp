#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/comparison.hpp"
#include "compare/residual_analysis.hpp"
#include "model/model.hpp"
#include "runs/run.hpp"

namespace fogcomp::compare {

/// Error of a model as the board computes it, and without the board's delay with the gyro's own
/// values: rms of the rows that count, deg/h.
struct BoardError {
  double rms_dph = 0;
  double without_delay_dph = 0;
  double rows = 0;  ///< total duration, in full rows

  /// Combines several runs.
  void add(const BoardError& other);
  /// Whether the delay makes more than 1 % of the error: then both are printed.
  bool delay_matters() const;
};

/// "as the board computes it the residual is 1062, without the board's delay (...) 166.8 deg/h".
std::string delay_words(const BoardError& error);

/// `comparison`: of this model on this run.
BoardError board_error(const model::Model& model, const runs::Run& run,
                       const Comparison& comparison);

/// What a model promises of a run that it was not fitted to, and whether it holds: means over ten
/// minutes, by which white noise is small beside the drift.
struct PredictiveBand {
  double row_s = 0;
  std::vector<double> time_s;
  std::vector<double> residual_dph;  ///< measured less modelled, as the board computes it
  std::vector<double> sigma_dph;     ///< one standard deviation promised

  /// Fraction of the means within so many standard deviations: 0.68 within 1, 0.95 within 2.
  double share_within(double sigmas) const;
};

/// The standard deviation is that of the drift (series/signal_series.hpp) and of the noise:
/// white, flicker over the run, a random walk since its start, and the bias of another power-on.
/// Nothing if the model does not know its uncertainty, or the run is shorter than two means.
std::optional<PredictiveBand> band_of(const model::Model& model, const runs::Run& run);

struct ModelOnRun {
  Comparison comparison;
  ResidualAnalysis analysis;
  BoardError error;  ///< of the whole run
  std::optional<PredictiveBand> band{};
};

/// In rows of `row_s` seconds. Throws InputError if the run lacks a column that the model needs.
ModelOnRun try_model(const model::Model& model, const runs::Run& run, double row_s);

/// Bias of a power-on less that of the first, with the model's drift refitted to all of them:
/// change from one power-on to the next (fit/turn_on_bias.hpp).
struct TurnOnBias {
  std::string run;
  double from_s = 0;  ///< time of a power-on within the run; 0 for the run's own
  std::string reference;
  double above_dph = 0;
  double sigma_dph = 0;
  bool certain = false;  ///< noise does not explain it

  /// " from 3600 s on", to be read behind `run`; "" for the run's own.
  std::string from_words() const;
};

/// What the recordings of a gyro show of its bias from one power-on to the next.
struct TurnOn {
  std::vector<TurnOnBias> biases;  ///< of the second power-on, the third...; where they tell it
  double repeatability_dph = 0;    ///< standard deviation, of all together
  /// Noise as within the recordings does not explain a bias or the spread; slower noise and what
  /// the model lacks may, unless a bias is certain.
  bool differs = false;

  /// Whether each power-on can have a bias of its own: they differ, and the recordings tell these
  /// from the model's effects.
  bool can_be_own() const { return differs && !biases.empty(); }
  /// nullptr if none is.
  const TurnOnBias* first_certain() const;
  std::string differs_words() const;
  /// The same without a certain bias: what it may be, and what would tell.
  std::string doubt_words() const;
};

/// One model on every run, in the order of the command line.
struct ModelOnRuns {
  std::string file;
  model::Model model;
  std::vector<ModelOnRun> runs;
  TurnOn turn_on{};

  /// The run with the largest drift left, deg/h rms (floor_removed()).
  const ModelOnRun& worst() const;
  /// Fraction of all rows beyond the trained temperatures.
  double extrapolated_fraction() const;
};

/// First the model with the smallest rms error on its worst run, then the others in their order.
std::vector<const ModelOnRuns*> best_first(const std::vector<ModelOnRuns>& models);

/// Whether the noise floor lies above the residual by more than its own uncertainty.
bool is_below_floor(const Comparison& comparison);

}  // namespace fogcomp::compare
