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
  std::uint64_t denoised = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const FaultSchedule schedule = FaultScheduler(seed).draw();
    const DriftVerdict verdict = run(schedule, seed);
    if (!complaint(verdict).empty()) print(schedule);
    EXPECT_EQ(complaint(verdict), "") << "seed " << seed;
    trusted += static_cast<double>(verdict.trusted);
    samples += static_cast<double>(verdict.samples);
    denoised += verdict.denoised_valid;
  }
  std::printf("%.1f %% of the rates trusted, %.1f million denoised\n", 100 * trusted / samples,
              1e-6 * static_cast<double>(denoised));
  EXPECT_GT(trusted, samples / 4) << "or the test says little";
  EXPECT_GT(denoised, 1'000'000U) << "or the test says little";
}

// What a board sends that turns and loses samples, with a mark that ends as early as this. `slip`:
// it leaves out the loss.
bool judged_right(std::uint64_t lost, std::uint64_t early, std::uint64_t slip) {
  constexpr std::uint64_t kGapAt = 100;
  constexpr std::int32_t kPerSample = 180 * 1024;
  const fogcomp::board::BoardTable table = fog::test::denoiser_table({"db4", 2});
  const fog::ModelParameters parameters = fogcomp::board::read_board_table(table, "test");
  const std::uint64_t delay = fog::denoise_delay(8, 2);
  fog::test::DenoisedJudge judge(parameters.denoise, "db4");
  bool right = true;
  for (std::uint64_t time = 0; time < 2 * kGapAt; ++time) {
    judge.begin_sample();
    if (time >= kGapAt && time < kGapAt + lost) continue;
    const auto turned = [](std::uint64_t samples) {
      return fog::Rate::from_raw(static_cast<std::int32_t>(samples) * kPerSample);
    };
    fog::OutputSample out;
    out.compensated = turned(time);
    const bool after = time >= kGapAt + lost;
    const bool marked = after && time < kGapAt + lost + delay - early;
    const bool old = after && time < kGapAt + lost + delay;
    out.denoised = turned(time < delay ? 0 : time - delay - (old ? slip : 0));
    out.status = fog::status_if(time < delay, fog::Status::denoiser_filling) |
                 fog::status_if(marked, fog::Status::denoised_invalid);
    right = judge.take(out) && right;
  }
  return right && judge.valid() > kGapAt;
}

TEST(DenoisedJudge, MarkEndsASampleTooEarly_Found) {
  for (const std::uint64_t lost : {1U, 2U, 30U}) {
    EXPECT_TRUE(judged_right(lost, 0, lost)) << lost;
    EXPECT_FALSE(judged_right(lost, 1, lost)) << lost;
    EXPECT_FALSE(judged_right(lost, 20, lost)) << lost;
  }
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
