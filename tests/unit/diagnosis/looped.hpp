#pragma once

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "diagnosis/ladder.hpp"

namespace fog::test {

/// Stepwise selection of a model on one recording. Its progress, 0..1, never goes back. `offered`:
/// as DiagnosisData takes it.
inline fogcomp::diagnosis::Ladder looped(const fogcomp::model::Model& model,
                                         const fogcomp::recording::Recording& recording,
                                         int max_steps,
                                         std::vector<fogcomp::model::EffectTerm> offered = {}) {
  fogcomp::runs::Runs runs;
  runs.training.push_back(fogcomp::runs::run_of(recording, {model.average_s}));
  const fogcomp::diagnosis::DiagnosisData data(model, runs.training, std::move(offered));
  double progress = 0;
  fogcomp::diagnosis::DiagnosisSettings settings;
  settings.progress = [&](double done) {
    EXPECT_GE(done, progress);
    EXPECT_LE(done, 1);
    progress = done;
  };
  return stepwise_selection(model, data, runs, max_steps, settings);
}

}  // namespace fog::test
