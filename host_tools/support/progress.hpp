#pragma once

#include <chrono>
#include <string>

namespace fogcomp {

/// A progress bar with the remaining time, on stderr if that is a terminal, and only for work that
/// takes longer than 2 s.
class Progress {
 public:
  explicit Progress(std::string label);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `fraction` of the work done, 0 to 1. Cheap enough for a call every few thousand rows.
  void update(double fraction);

 private:
  std::string label_;
  bool on_terminal_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_;
};

/// While this object lives, Ctrl-C asks long work to end early with its present result; a second
/// Ctrl-C ends the program. One object at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  bool interrupted() const;
};

}  // namespace fogcomp
