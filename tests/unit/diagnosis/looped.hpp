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
  fogcomp::diagnosis::DiagnosisData data(model, std::move(offered));
  fogcomp::diagnosis::JudgingRuns runs;
  runs.training.runs.push_back(fogcomp::compare::run_in_blocks(recording, model.average_s));
  data.add(runs.training.runs[0]);
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
