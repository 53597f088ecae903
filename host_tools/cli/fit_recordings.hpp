#pragma once

#include <string>
#include <vector>

#include "cli/denoise_options.hpp"
#include "cli/fit_models.hpp"
#include "cli/recording_options.hpp"
#include "cli/training_options.hpp"
#include "compare/run_in_blocks.hpp"
#include "fit/fit_model.hpp"
#include "fit/network_inputs.hpp"
#include "fit/physical_lags.hpp"
#include "model/catalogue.hpp"

namespace fogcomp::cli {

/// A model fitted to recordings, and what can be said of it.
struct Fit {
  Model model;  ///< with its history
  Eigen::Index rows = 0;
  double row_s = 0;
  std::vector<RunInBlocks> runs;
  FitResult result;
  double delay_rms_dph = 0;              ///< of the error, what the board's delay makes
  std::vector<std::string> step_places;  ///< of each step found: recording and segment
  bool searched_steps = false;
  std::vector<PhysicalLag> physical_lags;
};

/// What a Ctrl-C means while a network is trained.
enum class OnInterrupt : std::uint8_t {
  keep_best,  ///< the training ends there, as for somebody who has seen enough of its progress bar
  stop,       ///< the program ends, as ever
};

/// Everything that decides what a fit finds: effects, network, rows, denoisers.
struct FitOptions : OptionGroup {
  using OptionGroup::OptionGroup;

  Text effects{this,
               {"effects", "LIST", "NAME,NAME:p=VALUE,...; ? for a value: identified"},
               effect_names()};
  Texts expressions{
      this, {"effect-expr", "EXPR", "a term of your own: 'late = lag(T,?tau[60,900]) - T'"}};
  Text model{
      this,
      {"model", "NAME", "instead of --effects, --network; a board runs each: " + fit_model_list()},
      fit_model_names()};
  Number average{this, {"average", "S", "rows of the fit, seconds", "10"}, {1e-3, 1e6}};
  Flag run_offsets{this, "run-offsets", "a bias for each recording; the model keeps the first"};
  TrainingOptions training{this};
  Text inputs{
      this,
      {"inputs", "LIST", "of the network: also lagged_temperature:tau=S, elapsed, supply, ...",
       "temperature,temperature_rate", kRare},
      network_input_names()};
  Number derivative_tau{
      this,
      {"derivative-tau", "S", "time constant of the two lags behind dT/dt", "30", kRare},
      {1e-3, 1e5}};
  Choice<std::string> wavelet{this,
                              {"wavelet", "NAME", "of the board's denoiser", "sym8", kRare},
                              as_named(wavelet_names())};
  Integer<int> levels{
      this, {"levels", "N", "of the board's denoiser, 0 for none", "5", kRare}, 0, 10};
  Choice<fog::ThresholdRule> threshold{
      this,
      {"threshold", "RULE", "of the board: heursure and sqtwolog follow the noise; or fixed",
       "heursure", kRare},
      in_order<fog::ThresholdRule>(kBoardRules)};
  HardOrSoft mode{this, kRare};
  Choice<std::optional<ThresholdRule>> denoise_rows{
      this,
      {"denoise-rows", "RULE", "denoise what the network is trained on, by heursure, ...", "none",
       kRare},
      row_rules()};

 private:
  static Choice<std::optional<ThresholdRule>>::Meanings row_rules();
};

/// Throws InputError as fit_recordings() does for the options alone.
void check_fit_options(const FitOptions& options, const RecordingOptions& recording);

/// Fits what the options ask for to `files`. Throws InputError for options that contradict and for
/// recordings that lack what an effect needs.
Fit fit_recordings(const FitOptions& options, const RecordingOptions& recording,
                   const std::vector<std::string>& files, OnInterrupt on_interrupt);

}  // namespace fogcomp::cli
