#pragma once

#include <vector>

#include "model/model.hpp"
#include "planning/information.hpp"
#include "planning/operating_box.hpp"
#include "series/block_series.hpp"
#include "simulation/programme.hpp"

namespace fogcomp::planning {

/// What is to be determined, and how well it can be seen.
struct Question {
  std::vector<model::EffectTerm> terms;  ///< with coefficients
  double derivative_tau_s = 30;
  double white_dph_rthz = 0;    ///< angle random walk: standard deviation of a mean over 1 s
  double flicker_dph = 0;       ///< bias instability B
  double walk_dph_per_rth = 0;  ///< rate random walk K
  OperatingBox use;
};

/// What a programme would tell about a question.
struct Expectation {
  double hours = 0;
  DriftError error;  ///< over a day in the box
};

/// Tells what any programme would tell about one question, before anybody has run it: a typical
/// gyro is taken through it, and then through a day in the box of use.
class Foresight {
 public:
  /// Throws InputError for an effect that is the event of a recording, or follows the input rate in
  /// a box without one.
  explicit Foresight(Question question);

  /// Several threads may ask at once.
  Expectation expect(const simulation::Programme& programme) const;
  /// Of all effects of the catalogue that something in the box moves, each beside the others of the
  /// question; rms over a day in the box.
  std::vector<VisibleSize> visible(const simulation::Programme& programme) const;
  const Question& question() const { return question_; }

 private:
  template <class Ask>
  auto ask(const simulation::Programme& programme, const Ask& question) const;

  Question question_;
  series::BlockSeries day_;
};

}  // namespace fogcomp::planning
