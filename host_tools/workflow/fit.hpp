#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/model_on_runs.hpp"
#include "fit/derivative_choice.hpp"
#include "fit/fit_model.hpp"
#include "network/network_training.hpp"
#include "runs/run.hpp"
#include "runs/runs.hpp"
#include "series/signal_series.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

/// Where neither a request nor its prior says another.
constexpr double kDerivativeTau_s = 30;

/// All settings of a fit.
struct FitRequest {
  std::vector<std::string> runs;  ///< recordings
  std::string serial{};           ///< of the gyro, for the model
  /// scale_factor is also the board's: it is stored for recordings in deg/h as well.
  recording::ReadOptions reading;

  std::optional<std::string>
      preset;  ///< one of preset_names(); nothing: the following members decide
  std::optional<std::string> effects;  ///< in the syntax of parse_effects(); nothing: the preset's
  std::vector<std::string> expressions;  ///< `NAME = EXPRESSION`
  /// A model file of the same gyro, whose effects and values are what is known before the fit.
  std::optional<std::string> prior{};
  /// A lot file (learn_lot()): what its gyros teach is what is known before the fit, but for this
  /// gyro itself, by `serial` or by its recordings.
  std::optional<std::string> lot{};
  double average_s = 10;  ///< rows of the fit, > 0
  /// Of each of the two lags of dT/dt, > 0; nothing: the prior's, or kDerivativeTau_s.
  std::optional<double> derivative_tau_s{};
  bool run_offsets = false;  ///< a bias for each power-on, even if they do not certainly differ
  model::DenoiseSettings board_denoiser;

  std::optional<int> hidden;           ///< neurons, 0 to kMaxTrainedHidden; nothing: the preset's
  std::optional<std::string> trainer;  ///< one of trainer_names(); nothing: the preset's, or lm
  fog::Activation activation = fog::Activation::logsig;
  network::TrainerSettings training;  ///< go_on is replaced by the observer's
  bool force_network = false;
  std::string network_inputs = "temperature,temperature_rate";
  /// Rule for denoising the network's training rows, with the board's wavelet; nothing: no
  /// denoising.
  std::optional<denoise::ThresholdRule> row_denoising;
};

/// A fitted model and its assessment.
struct FitOutcome {
  model::Model model;  ///< with its history
  Eigen::Index rows = 0;
  double row_s = 0;
  std::vector<runs::Run> runs;
  fit::FitResult result;
  double delay_rms_dph = 0;  ///< part of the error due to the board's delay
  std::optional<fit::DerivativeChoice> better_derivative{};
  compare::TurnOn turn_on;

  std::size_t refused_rows() const;  ///< of all recordings
  /// From the trainer lm only; nothing without a network.
  std::optional<double> determined_weights() const;
  bool network_dropped() const;  ///< a network was trained on request, but did not help
  /// The model on its own recordings, judged like compare(); `file` is the model's.
  compare::ModelOnRuns on_its_runs(const std::string& file) const;
};

/// Throws InputError like fit() for everything that can be checked before a recording is read:
/// contradictory settings, unknown effects. Returns the effects, of its prior if it has one.
std::vector<model::EffectTerm> check(const FitRequest& request);

/// Fits effects, then the network on their residual. Throws InputError for contradictory settings
/// and for recordings without an input of an effect.
FitOutcome fit(const FitRequest& request, const Observer& observer = {});
/// The same with recordings already read by training_runs(). `known`: of their rows, kept from an
/// earlier fit in the same ones; nullptr: computed anew.
FitOutcome fit(const FitRequest& request, runs::Runs runs, const Observer& observer = {},
               const fit::KnownRegressors* known = nullptr);
runs::Runs training_runs(const FitRequest& request, const Observer& observer = {});

/// Values of FitRequest::preset: models of the literature that a board can run.
std::vector<std::string> preset_names();

/// Whether the preset, or none, uses FitRequest::effects. Throws InputError for a model that no
/// board can run, or an unknown one.
bool takes_effects(const std::optional<std::string>& preset);

/// The effects and the network of a request.
struct WantedModel {
  std::string effects;
  network::NetworkSettings network;   ///< 0 hidden neurons: none
  bool network_is_the_model = false;  ///< there is nothing to compare it with
  bool order_by_validation = false;   ///< of bias_temperature
};

/// Throws InputError if preset and another member contradict.
WantedModel wanted_model(const FitRequest& request);

/// The terms of its effects and expressions, without coefficients. Throws InputError like
/// wanted_model(), parse_effects() and add_expression().
std::vector<model::EffectTerm> wanted_terms(const FitRequest& request);

/// The terms with the polynomial's order, 1 to 9, that cross-validation chooses.
std::vector<model::EffectTerm> with_best_order(std::vector<model::EffectTerm> terms,
                                               const series::Rows& rows);

}  // namespace fogcomp::workflow
