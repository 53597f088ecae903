#pragma once

#include <optional>
#include <string>

#include "support/progress.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::cli {

/// Meaning of Ctrl-C while a network is trained.
enum class OnInterrupt : std::uint8_t {
  stop,       ///< ends the program
  keep_best,  ///< ends the training and keeps the best network so far
};

/// Shows progress on stderr: notes, remarks, and a progress bar for each stage.
class Watch {
 public:
  explicit Watch(OnInterrupt on_interrupt = OnInterrupt::stop) : on_interrupt_(on_interrupt) {}
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Refers to this object.
  workflow::Observer observer();

 private:
  bool update(const std::string& stage, double done);

  OnInterrupt on_interrupt_;
  std::string stage_;
  std::optional<Progress> bar_;
  std::optional<InterruptGuard> guard_;
};

/// Output without a terminal: notes and remarks, one line each on stderr.
workflow::Observer on_stderr();

}  // namespace fogcomp::cli
