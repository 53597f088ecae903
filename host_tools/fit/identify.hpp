#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "noise/noise_model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// A bias step that a fit found. It belongs to one recording.
struct FoundStep {
  std::size_t run = 0;  ///< which of the recordings, from 0
  double time_s = 0;    ///< since power-on
  double time_sigma_s = 0;
  double size_dph = 0;
  double size_sigma_dph = 0;
};

/// What a fit found out beside the coefficients, which are in the model.
struct Identification {
  Eigen::VectorXd residual_dph;  ///< per row, measured - input - effects
  noise::NoiseModel noise;       ///< what the rows were weighted with
  double birge_ratio = 0;        ///< rms of the whitened residual: 1 where only that noise is left
  std::size_t outliers = 0;      ///< rows left out (outlier_rows.hpp)
  Eigen::VectorXd row_weights;   ///< Rows::weights, 0 for outliers and masked rows
  std::size_t masked = 0;        ///< rows left out because a bias step lies in them
  std::vector<FoundStep> steps;  ///< each is a term of the model too, behind the others
  /// Per effect, deg/h: the smallest peak of this effect that these recordings show at 5 sigma.
  std::vector<double> visible_dph;
  std::vector<std::string> warnings;    ///< whole sentences
  std::vector<double> run_offsets_dph;  ///< of the second, third... recording against the first
};

/// Whether identify() is to look for bias steps: an event without a time is among the terms.
bool searches_steps(const std::vector<model::EffectTerm>& terms);

struct IdentifySettings {
  /// Every recording has a bias of its own (turn-on repeatability); the model keeps the first
  /// one's.
  bool run_offsets = false;
  /// How many steps an event without a time may become. Those that a fit found before are searched
  /// for anew, as many as they are.
  std::size_t max_new_steps = 8;
  /// Told how much of the search for shape parameters is done, 0..1; or empty.
  std::function<void(double)> progress{};
};

/// Identifies coefficients, and those shape parameters that model.terms marks, from all recordings
/// of `series` together; sets the trained ranges.
///
/// Noise-weighted: rows are whitened with white + Gauss-Markov noise taken from the soaks. Shape
/// parameters by variable projection: a bounded grid each, then Gauss-Newton on all together.
/// Smoothed temperatures as instruments keep the sensor's noise out of the coefficients. Outliers
/// count for nothing. Standard deviations are those of coefficient_covariance().
///
/// An event without a time is searched for (step_search.hpp): any number of such terms replace it
/// in model.terms, each fitted to the recording in which it lies. Throws InputError for
/// too few rows, and for effects that the recordings cannot tell apart at all.
Identification identify(model::Model& model, const series::SignalSeries& series,
                        const IdentifySettings& settings = {});

}  // namespace fogcomp::fit
