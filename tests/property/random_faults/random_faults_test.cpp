// drift_under_faults_test.cpp tests every fault once; here they come at random and overlap.
#include <gtest/gtest.h>

#include <cstdio>

#include "support/fault_schedule.hpp"

namespace {

using fog::test::DriftVerdict;
using fog::test::FaultSchedule;
using fog::test::FaultScheduler;

// 10^4 of them: tests/bench/random_faults.cpp.
TEST(RandomFaults, LeaveNoTrustedRateWithAWrongDrift) {
  double trusted = 0;
  double samples = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const FaultSchedule schedule = FaultScheduler(seed).draw();
    const DriftVerdict verdict = run(schedule, seed);
    if (!complaint(verdict).empty()) print(schedule);
    EXPECT_EQ(complaint(verdict), "") << "seed " << seed;
    trusted += static_cast<double>(verdict.trusted);
    samples += static_cast<double>(verdict.samples);
  }
  std::printf("%.1f %% of the rates trusted\n", 100 * trusted / samples);
  EXPECT_GT(trusted, samples / 4) << "or the test says little";
}

}  // namespace
