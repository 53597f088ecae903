#pragma once

namespace fogcomp {

/// While one lives, Ctrl-C asks long work to end early with what it has (a second Ctrl-C ends the
/// program as ever). One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  bool interrupted() const;
};

}  // namespace fogcomp
