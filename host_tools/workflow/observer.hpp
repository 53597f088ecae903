#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "recording/recording.hpp"

namespace fogcomp::workflow {

/// Thrown when the observer cancels work that has no usable result yet.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

/// Callbacks about work in progress. Each may be empty. One is called at a time: `progress` by
/// whichever thread does the work, the others by the caller's (in paper() by any).
struct Observer {
  /// A sentence about the data that limits the result.
  std::function<void(const std::string&)> note{};
  /// Left-out or ignored data of a recording: `FILE: what`.
  std::function<void(const std::string&)> remark{};
  /// Fraction of a stage that is done, 0..1. false requests the end: fit() then keeps the network
  /// as trained so far (kTraining); other work throws Cancelled.
  std::function<bool(const std::string& stage, double done)> progress{};

  void say(const std::vector<std::string>& notes) const {
    for (const std::string& each : notes) {
      if (note) note(each);
    }
  }
  /// false if the observer requests the end.
  bool should_continue(const std::string& stage, double done) const {
    return !progress || progress(stage, done);
  }
  /// The same options with this observer, which must outlive the reading.
  recording::ReadOptions with_observer(recording::ReadOptions reading) const {
    reading.watch.remark = remark;
    if (progress) {
      reading.watch.progress = [this](const std::string& stage, double done) { tell(stage, done); };
    }
    return reading;
  }
  /// Reports progress; throws Cancelled.
  void tell(const std::string& stage, double done) const {
    if (!should_continue(stage, done)) throw Cancelled();
  }
  /// The same as a callback for a library; empty without an observer.
  std::function<void(double)> of_stage(const std::string& stage) const {
    if (!progress) return {};
    return [report = progress, stage](double done) {
      if (!report(stage, done)) throw Cancelled();
    };
  }
};

inline const std::string kTraining = "training";

}  // namespace fogcomp::workflow
