#pragma once

#include <string>
#include <vector>

#include "cli/arguments.hpp"
#include "compare/run_in_blocks.hpp"
#include "fit/fit_model.hpp"
#include "fit/physical_lags.hpp"

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
std::vector<Option> fit_options();

/// Throws InputError as fit_recordings() does for the options alone.
void check_fit_options(const Arguments& arguments);

/// Fits what fit_options() and the options of recordings ask for to `files`. Throws InputError for
/// options that contradict and for recordings that lack what an effect needs.
Fit fit_recordings(const Arguments& arguments, const std::vector<std::string>& files,
                   OnInterrupt on_interrupt);

}  // namespace fogcomp::cli
