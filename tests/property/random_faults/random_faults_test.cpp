// drift_under_faults_test.cpp tests every fault once; here they come at random and overlap.
#include <gtest/gtest.h>

#include <cstdio>

#include "support/fault_schedule.hpp"

namespace {

using fog::test::DriftVerdict;
using fog::test::Fault;
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

// From schedule 4071: a jump of a sensor that drifts is bridged from one wrong temperature to the
// next, and what the drift is off by is that error. A witness that was told the right temperature
// within the bridge did not explain it.
TEST(RandomFaults, DriftingSensor_JumpIsBridged_ErrorExplained) {
  FaultSchedule schedule;
  schedule.memory.lag_s = 10.3;
  schedule.duration_s = 1200;
  schedule.faults = {{Fault::Kind::temperature_drifts, 700, 1200, -3.8},
                     {Fault::Kind::temperature_offset, 737, 742.24, -14.5}};
  const DriftVerdict verdict = run(schedule, 1);
  EXPECT_EQ(complaint(verdict), "");
  EXPECT_GT(verdict.trusted, verdict.samples / 2) << "or the test says little";
}

// Nothing else is wrong: inputs and temperatures go beyond what the model was trained for.
TEST(RandomFaults, TrainedForPart_BeyondIt_NotTrusted) {
  for (const fog::Input input : {fog::Input::supply, fog::Input::vibration}) {
    FaultSchedule schedule;
    schedule.board.input = {input, 12'000};  // beyond from 1480 s on
    schedule.board.trained_part =
        0.7;  // of ramps more than there are: they are trained by half more
    schedule.duration_s = 2200;
    const DriftVerdict verdict = run(schedule, 1);
    EXPECT_EQ(complaint(verdict), "") << description_of(input).name;
    EXPECT_GT(verdict.trusted, verdict.samples / 5) << "or the test says little";
    EXPECT_LT(verdict.trusted, verdict.samples / 2) << "or nothing is beyond";
  }
}

// From schedules 122, 135 and 147: a held drift was called accurate for as long as the temperature
// allowed, while a field went on. KVH frames were valid, 0.14 to 0.31 deg/h off.
TEST(RandomFaults, InputMovesWhileDriftIsHeld_NotValid) {
  FaultSchedule schedule;
  schedule.board.frames = {fog::OutputSelection::kvh, 0};
  schedule.board.judged_by_validity = true;
  schedule.board.sample_rate_hz = 41;
  schedule.duration_s = 1200;
  for (const fog::Input input : {fog::Input::magnetic, fog::Input::light_power}) {
    schedule.board.input = {input, 60};
    for (const Fault& fault : {Fault{Fault::Kind::wrong_temperature, 700, 740, -54.6},
                               Fault{Fault::Kind::no_temperature, 700, 704},
                               Fault{Fault::Kind::input_other_kind, 700, 704, 2},
                               Fault{Fault::Kind::input_missing, 700, 704}}) {
      schedule.faults = {fault};
      const DriftVerdict verdict = run(schedule, 1);
      EXPECT_EQ(complaint(verdict), "") << name_of(fault.kind);
      EXPECT_GT(verdict.trusted, verdict.samples / 2) << "or the test says little";
    }
  }
}

}  // namespace
