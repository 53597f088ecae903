// drift_under_faults_test.cpp tests every fault once; here they come at random and overlap.
#include <gtest/gtest.h>

#include <cstdio>

#include "support/fault_schedule.hpp"
#include "support/typical_effects.hpp"

namespace {

using fog::test::DriftVerdict;
using fog::test::FaultSchedule;
using fog::test::FaultScheduler;

constexpr double kBoundDph = 0.05;
constexpr double kSamples = 1e6;
constexpr double kRunS = kSamples / 200;

// 10^4 of them: tests/bench/random_faults.cpp.
TEST(RandomFaults, LeaveNoTrustedRateWithAWrongDrift) {
  const fog::test::ScheduledBoards boards(fog::test::paper_like_model());
  double trusted = 0;
  double samples = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const FaultSchedule schedule = FaultScheduler(seed).draw(kRunS);
    const DriftVerdict verdict = boards.run(schedule, kRunS, seed);
    if (verdict.worst_dph > kBoundDph) print(schedule);
    EXPECT_LE(verdict.worst_dph, kBoundDph)
        << "seed " << seed << " at " << verdict.worst_at_s << " s";
    trusted += static_cast<double>(verdict.trusted);
    samples += static_cast<double>(verdict.samples);
  }
  std::printf("%.1f %% of the rates trusted\n", 100 * trusted / samples);
  EXPECT_GT(trusted, samples / 4) << "or the test says little";
}

}  // namespace
