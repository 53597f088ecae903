#include <gtest/gtest.h>

#include <random>

#include "fit/add_effect.hpp"
#include "unit/fit/recording_with_steps.hpp"
#include "unit/fit/simulated_addition.hpp"

namespace {

using namespace fog::test;

// A cut of a run with a step of this size there.
bool is_accepted(std::uint64_t seed, double at_s, double size_dph) {
  fogcomp::recording::Recording recording = noisy_recording(seed);
  add_step(recording, at_s, size_dph);
  fogcomp::runs::Runs runs = runs_of(truth(), {});
  runs.training.push_back(fogcomp::runs::run_of(recording, {10}));
  const fogcomp::model::Model given = incomplete(kComplete);
  const std::vector<fogcomp::recording::Cut> cuts{{"", at_s}};
  return fogcomp::fit::add_effect(given, fogcomp::fit::change_cuts(given.terms, cuts),
                                  runs.with(cuts), {})
      .accepted;
}

int accepted_of(int draws, double size_dph) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(3000, 33000);
  int accepted = 0;
  for (int i = 0; i < draws; ++i)
    accepted += is_accepted(static_cast<std::uint64_t>(i) + 1, place(random), size_dph) ? 1 : 0;
  return accepted;
}

// Chance reaches the gain that is needed once in 100 times at most.
TEST(Cuts, WithoutAStep_AreRefused) {
  EXPECT_LE(accepted_of(40, 0), 2);
}

TEST(Cuts, AtAStepOfFiveSigmaOfARow_AreAccepted) {
  EXPECT_GE(accepted_of(20, 5 * kWhiteDph), 19);
}

}  // namespace
