#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "recording/recording.hpp"

namespace fogcomp::workflow {

/// The observer asked for the end of work that has nothing to show for itself yet.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

/// Who hears of work under way. Each may be empty; all are called in the caller's thread, but
/// for paper(), whose threads take turns.
struct Observer {
  /// A sentence on what was read: it limits the answer.
  std::function<void(const std::string&)> note{};
  /// What of a recording is left out or ignored: `FILE: what`.
  std::function<void(const std::string&)> remark{};
  /// How much of a stage is done, 0..1. False asks for the end: fit() then keeps the network as far
  /// as it is trained (kTraining); any other work throws Cancelled.
  std::function<bool(const std::string& stage, double done)> progress{};

  void say(const std::vector<std::string>& notes) const {
    for (const std::string& each : notes) {
      if (note) note(each);
    }
  }
  /// False where the observer has had enough.
  bool goes_on(const std::string& stage, double done) const {
    return !progress || progress(stage, done);
  }
  /// The same options, heard by this observer, which must outlive the reading.
  recording::ReadOptions heard(recording::ReadOptions reading) const {
    reading.watch.remark = remark;
    if (progress) {
      reading.watch.progress = [this](const std::string& stage, double done) { tell(stage, done); };
    }
    return reading;
  }
  /// At the start of a stage, or between its parts; throws Cancelled.
  void tell(const std::string& stage, double done) const {
    if (!goes_on(stage, done)) throw Cancelled();
  }
  /// The same for a library to call; empty where nobody listens.
  std::function<void(double)> of_stage(const std::string& stage) const {
    if (!progress) return {};
    return [report = progress, stage](double done) {
      if (!report(stage, done)) throw Cancelled();
    };
  }
};

inline const std::string kTraining = "training";

}  // namespace fogcomp::workflow
