#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fit/departure.hpp"
#include "fit/known_regressors.hpp"
#include "fit/prior.hpp"
#include "model/model.hpp"
#include "noise/noise_model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// Results of a fit except the coefficients, which are in the model.
struct Identification {
  Eigen::VectorXd residual_dph;  ///< per row, measured - input - effects
  noise::NoiseModel noise;       ///< noise used for the weights
  double birge_ratio = 0;        ///< rms of the whitened residual: 1 if only that noise is left
  std::size_t outliers = 0;      ///< rows left out (outlier_rows.hpp)
  Eigen::VectorXd row_weights;   ///< Rows::weights, 0 for outliers and masked rows
  std::size_t masked = 0;        ///< rows left out because a cut lies in them
  /// Per effect, deg/h: smallest peak that these recordings show at 5 sigma.
  std::vector<double> visible_dph;
  std::vector<std::string> warnings;  ///< whole sentences
  double soak_sigma_dph =
      0;  ///< std of the drift in the soak that is known worst (SoakUncertainty)
  std::vector<double> run_offsets_dph;   ///< of the second, third... power-on against the first
  double turn_on_repeatability_dph = 0;  ///< std of the power-ons' biases, if each has its own
  std::optional<Prior> prior;            ///< that the fit was given
  std::vector<Departure> departures;     ///< of each of its unknowns
};

struct IdentifySettings {
  /// Every power-on has its own bias (turn-on repeatability), whose spread is found with it
  /// (turn_on_repeatability.hpp). So it is if a run is cut, whatever this says, and each part of
  /// that run has its own. The model keeps the mean of those with which the power-ons end.
  bool run_offsets = false;
  /// Called with the fraction of the shape search done, 0..1; may be empty.
  std::function<void(double)> progress{};
  /// Of the model's terms, which are the prior's; nothing: the rows alone tell.
  std::optional<Prior> prior{};
};

/// Identifies coefficients, and the shape parameters that model.terms marks, from all recordings of
/// `series` together; sets the trained ranges.
///
/// Noise-weighted: rows are whitened with white and Gauss-Markov noise estimated in the soaks.
/// Shape parameters by variable projection: a bounded grid for each, then Gauss-Newton on all.
/// Outliers have weight 0. These values compensate best on a board, whose derivative has noise,
/// steps and a delay; the gyro's own, and all uncertainties, are those of gyro_fit.hpp.
///
/// The terms have no events. Throws InputError for too few rows, and for effects that the
/// recordings do not determine.
Identification identify(model::Model& model, const KnownRegressors& known,
                        const IdentifySettings& settings = {});

/// An unknown before a fit with a prior and after it, in the catalogue's unit.
struct PriorUpdate {
  std::string name;
  std::string unit;
  model::Estimate before;
  model::Estimate after;
  Departure departure;

  /// Share of what was known before in what is known now, 0..1.
  double from_before() const;
};

/// Of each unknown of a model that was fitted with a prior.
std::vector<PriorUpdate> prior_updates(const model::Model& model, const Identification& identified);

}  // namespace fogcomp::fit
