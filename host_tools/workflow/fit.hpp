#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/model_on_runs.hpp"
#include "compare/run_in_blocks.hpp"
#include "fit/fit_model.hpp"
#include "fit/physical_lags.hpp"
#include "fit/training_runs.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

/// Everything that decides what a fit finds.
struct FitRequest {
  std::vector<std::string> runs;  ///< recordings
  std::string serial{};           ///< of the gyro, for the model
  /// scale_factor is the board's as well: it counts for recordings in deg/h, too.
  recording::ReadOptions reading;

  std::optional<std::string> preset;     ///< one of preset_names(); nothing: what follows says all
  std::optional<std::string> effects;    ///< as parse_effects() takes them; nothing: the preset's
  std::vector<std::string> expressions;  ///< `NAME = EXPRESSION`
  double average_s = 10;                 ///< rows of the fit, > 0
  double derivative_tau_s = 30;          ///< of each of the two lags behind dT/dt, > 0
  bool run_offsets = false;              ///< a bias for each recording; the model keeps the first
  model::DenoiseSettings board_denoiser;

  std::optional<int> hidden;           ///< neurons, 0 to kMaxTrainedHidden; nothing: the preset's
  std::optional<std::string> trainer;  ///< one of trainer_names(); nothing: the preset's, or lm
  fog::Activation activation = fog::Activation::logsig;
  fit::TrainerSettings training;  ///< go_on is the observer's
  bool force_network = false;
  std::string network_inputs = "temperature,temperature_rate";
  /// Rule by which the rows that the network is trained on are denoised first, with the board's
  /// wavelet; nothing: they stay as they are.
  std::optional<denoise::ThresholdRule> row_denoising;
};

/// A model fitted to recordings, and what can be said of it.
struct FitOutcome {
  model::Model model;  ///< with its history
  Eigen::Index rows = 0;
  double row_s = 0;
  std::vector<compare::RunInBlocks> runs;
  fit::FitResult result;
  double delay_rms_dph = 0;              ///< of the error, what the board's delay makes
  std::vector<std::string> step_places;  ///< of each step found: recording and segment
  bool searched_steps = false;
  std::vector<fit::PhysicalLag> physical_lags;
  std::vector<compare::TurnOnBias> turn_on;  ///< of the second run, the third, ...

  std::size_t refused_rows() const;  ///< of all recordings
  /// Only lm knows; nothing without a network.
  std::optional<double> determined_weights() const;
  bool network_dropped() const;  ///< one was asked for and trained, and is not kept
  /// On its own recordings as compare() would judge it; `file` is the model's.
  compare::ModelOnRuns on_its_runs(const std::string& file) const;
};

/// Throws InputError as fit() does for what can be said before a recording is read: settings that
/// contradict, unknown effects.
void check(const FitRequest& request);

/// Effects, then the network on what they leave. Throws InputError for settings that contradict and
/// for recordings that lack what an effect needs.
FitOutcome fit(const FitRequest& request, const Observer& observer = {});
/// The same with the request's recordings read before, as training_runs() does.
FitOutcome fit(const FitRequest& request, fit::TrainingRuns training,
               const Observer& observer = {});
fit::TrainingRuns training_runs(const FitRequest& request, const Observer& observer = {});

}  // namespace fogcomp::workflow
