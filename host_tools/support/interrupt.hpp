#pragma once

namespace fogcomp {

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
