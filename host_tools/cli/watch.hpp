#pragma once

#include <optional>
#include <string>

#include "support/interrupt.hpp"
#include "support/progress.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::cli {

/// What Ctrl-C means while a network is trained.
enum class OnInterrupt : std::uint8_t {
  stop,       ///< ends the program
  keep_best,  ///< ends the training; the best network so far is kept
};

/// Shows work under way on stderr: notes, remarks, and a progress bar for each stage.
class Watch {
 public:
  explicit Watch(OnInterrupt on_interrupt = OnInterrupt::stop) : on_interrupt_(on_interrupt) {}
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Refers to this.
  workflow::Observer observer();

 private:
  bool update(const std::string& stage, double done);

  OnInterrupt on_interrupt_;
  std::string stage_;
  std::optional<Progress> bar_;
  std::optional<InterruptGuard> guard_;
};

/// What a process without a terminal says: notes and remarks, a line each on stderr.
workflow::Observer on_stderr();

}  // namespace fogcomp::cli
