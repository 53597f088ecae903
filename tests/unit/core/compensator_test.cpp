#include "core/pipeline/compensator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "model/drift_model.hpp"
#include "replay/replay.hpp"
#include "support/overflow_guard.hpp"
#include "support/sample_models.hpp"
#include "support/typical_effects.hpp"

namespace {

using fog::OutputSample;
using fog::SensorSample;
using fog::Status;

constexpr std::int32_t kDegree = 65536;

// The whole pipeline with the sample model at 200 Hz.
class CompensatorTest : public testing::Test {
 protected:
  CompensatorTest() { restart(); }

  void restart() {
    table_ = fogcomp::make_board_table(model_, {});
    parameters_ = fogcomp::read_board_table(table_, "test");
    pipeline_ = std::make_unique<fogcomp::HostCompensator>(parameters_);
  }

  OutputSample send(SensorSample sample) { return pipeline_->process(sample); }

  /// A good sample of a gyro with some noise.
  SensorSample sample() {
    ++sequence_;
    return {sequence_, 700 + (sequence_ * 37) % 11, 25 * kDegree, true, true};
  }
  OutputSample run(int samples) {
    OutputSample last;
    for (int i = 0; i < samples; ++i) last = send(sample());
    return last;
  }

  fogcomp::Model model_ = fog::test::paper_like_model();
  fogcomp::BoardTable table_;
  fog::ModelParameters parameters_;
  std::unique_ptr<fogcomp::HostCompensator> pipeline_;
  std::uint16_t sequence_ = 65000;  // wraps soon
};

TEST_F(CompensatorTest, SubtractsTheModelledDriftFromTheFirstSampleOn) {
  fogcomp::RealDriftModel real(model_, 1);
  real.start({25});
  for (int i = 0; i < 1000; ++i) {
    const SensorSample in = sample();
    const OutputSample out = send(in);
    ASSERT_NEAR(std::ldexp(out.drift.raw(), -10), real.drift_dph(), 2.0 / 1024);
    ASSERT_EQ(out.compensated.raw(), in.rate_counts - out.drift.raw());
    ASSERT_TRUE(out.compensated_valid());
  }
}

TEST_F(CompensatorTest, DriftOfABlockCountsFromTheNextBlockOn) {
  run(200);
  const fog::Rate before = run(1).drift;
  OutputSample last;
  for (int i = 1; i < 200; ++i) {
    SensorSample warm = sample();
    warm.temperature_q16 = 35 * kDegree;
    last = send(warm);
    ASSERT_EQ(last.drift, before);
  }
  EXPECT_NE(run(1).drift, before);
}

TEST_F(CompensatorTest, ScalesCountsByTheScaleFactor) {
  model_.scale_factor = 12345.678;
  restart();
  for (const std::int32_t counts : {1, -1, 1000, -98765, 7000000}) {
    SensorSample in = sample();
    in.rate_counts = counts;
    const OutputSample out = send(in);
    const double measured = std::ldexp(out.compensated.raw() + out.drift.raw(), -10);
    EXPECT_NEAR(measured, counts / 12345.678 * 3600, 0.6 / 1024 + std::abs(counts) * 1e-9);
  }
}

TEST_F(CompensatorTest, FlagsARateBeyondItsRangeAndClipsInsteadOfWrapping) {
  run(10);
  for (const std::int32_t counts : {INT32_MAX, INT32_MIN, 2101248000, -2101248000}) {
    SensorSample in = sample();
    in.rate_counts = counts;
    const OutputSample out = send(in);
    EXPECT_TRUE(any(out.status, Status::rate_out_of_range));
    EXPECT_FALSE(out.compensated_valid());
    EXPECT_EQ(out.compensated.raw() > 0, counts > 0);
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST_F(CompensatorTest, HoldsTheDriftWithoutATemperatureThenGivesItUpThenRecovers) {
  const fog::Rate drift = run(400).drift;
  const auto send_without_temperature = [&](int blocks) {
    OutputSample last;
    for (int i = 0; i < 200 * blocks; ++i) {
      SensorSample in = sample();
      in.temperature_valid = false;
      last = send(in);
    }
    return last;
  };
  OutputSample out = send_without_temperature(2);
  EXPECT_TRUE(any(out.status, Status::temperature_invalid | Status::drift_held));
  EXPECT_TRUE(out.compensated_valid());
  EXPECT_EQ(out.drift, drift);
  out = send_without_temperature(60);
  EXPECT_TRUE(any(out.status, Status::drift_given_up));
  EXPECT_FALSE(out.compensated_valid());
  out = run(401);
  EXPECT_FALSE(any(out.status, Status::drift_given_up | Status::drift_held));
  EXPECT_TRUE(any(out.status, Status::thermal_settling));
  EXPECT_TRUE(out.compensated_valid());
}

TEST_F(CompensatorTest, TakesAnImpossibleTemperatureForAMissingOne) {
  run(10);
  for (const std::int32_t degc : {-71, 131, 32767, -32768}) {
    SensorSample in = sample();
    in.temperature_q16 = degc * kDegree;
    const OutputSample out = send(in);
    EXPECT_TRUE(any(out.status, Status::temperature_invalid)) << degc;
    EXPECT_EQ(out.temperature.raw(), 25 * kDegree);
  }
}

TEST_F(CompensatorTest, ClampsAndFlagsATemperatureOutsideTheTrainedRange) {
  OutputSample out;
  for (int i = 0; i < 401; ++i) {
    SensorSample in = sample();
    in.temperature_q16 = 100 * kDegree;
    out = send(in);
  }
  EXPECT_TRUE(any(out.status, Status::temperature_clamped));
  EXPECT_TRUE(out.compensated_valid());
}

TEST_F(CompensatorTest, FlagsLostAndRepeatedSamplesAndKeepsTime) {
  run(150);
  sequence_ = static_cast<std::uint16_t>(sequence_ + 100);  // the block ends within the gap
  SensorSample in = sample();
  in.temperature_q16 = 26 * kDegree;
  EXPECT_TRUE(any(send(in).status, Status::sequence_gap));
  EXPECT_FALSE(any(run(1).status, Status::sequence_gap));
  --sequence_;  // the same number again
  EXPECT_TRUE(any(run(1).status, Status::sequence_gap));
}

TEST_F(CompensatorTest, AGapLongerThanTheHoldGivesTheDriftUp) {
  run(400);
  sequence_ = static_cast<std::uint16_t>(sequence_ + 200 * 62);
  const OutputSample out = run(2);
  EXPECT_TRUE(any(out.status, Status::drift_given_up));
}

TEST_F(CompensatorTest, CallsAGyroStuckAfterHalfASecondOfEqualCounts) {
  run(400);
  SensorSample stuck = sample();
  for (int i = 1; i < 100; ++i) {
    EXPECT_FALSE(any(send(stuck).status, Status::gyro_stuck)) << i;
    ++stuck.sequence;
  }
  EXPECT_TRUE(any(send(stuck).status, Status::gyro_stuck));
  sequence_ = stuck.sequence;
  EXPECT_FALSE(any(run(1).status, Status::gyro_stuck));
}

TEST_F(CompensatorTest, AnswersEverySampleWithTheFramesOfItsModel) {
  const fog::SensorFrame frame = fog::encode_sensor_frame(sample());
  for (const auto selection :
       {fog::OutputSelection::kvh, fog::OutputSelection::compact, fog::OutputSelection::both}) {
    const fogcomp::BoardTable table = fogcomp::make_board_table(model_, {200, selection});
    const fog::ModelParameters parameters = fogcomp::read_board_table(table, "test");
    const auto pipeline = std::make_unique<fogcomp::HostCompensator>(parameters);
    std::vector<std::uint8_t> out(fog::kMostOutputBytes);
    std::size_t size = 0;
    for (const std::uint8_t byte : frame) {
      ASSERT_EQ(size, 0U);
      size = pipeline->feed(byte, out.data());
    }
    const std::size_t expected = selection == fog::OutputSelection::kvh       ? 36
                                 : selection == fog::OutputSelection::compact ? 28
                                                                              : 64;
    EXPECT_EQ(size, expected);
  }
}

// A model that needs a second temperature and the field, at 200 Hz.
class ExtensionTest : public CompensatorTest {
 protected:
  ExtensionTest() {
    for (const char* name : {"axial_gradient", "magnetic"}) {
      for (const fogcomp::EffectTerm& term : fog::test::typical_terms()) {
        if (term.name == name) model_.terms.push_back(term);
      }
    }
    table_ = fogcomp::make_board_table(model_, {200, fog::OutputSelection::kvh, true});
    parameters_ = fogcomp::read_board_table(table_, "test");
    pipeline_ = std::make_unique<fogcomp::HostCompensator>(parameters_);
  }

  void take(fog::Input input, double value) {
    pipeline_->take({input, fog::ExtensionValue::from_raw(
                                static_cast<std::int32_t>(std::lround(value * 65536)))});
  }
  OutputSample run_with_inputs(int samples) {
    OutputSample last;
    for (int i = 0; i < samples; ++i) {
      take(fog::Input::temperature2, 26);
      take(fog::Input::magnetic, 50);
      last = run(1);
    }
    return last;
  }
};

TEST_F(ExtensionTest, SubtractsWhatTheInputsCauseFromTheFirstSampleOn) {
  fogcomp::RealDriftModel real(model_, 1);
  fogcomp::RealBlock block{25};
  block.extension[static_cast<std::size_t>(fog::Input::temperature2)] = 26;
  block.extension[static_cast<std::size_t>(fog::Input::magnetic)] = 50;
  real.start(block);
  for (int i = 0; i < 1000; ++i) {
    const OutputSample out = run_with_inputs(1);
    ASSERT_NEAR(std::ldexp(out.drift.raw(), -10), real.drift_dph(), 2.0 / 1024);
    ASSERT_TRUE(out.compensated_valid());
  }
}

TEST_F(ExtensionTest, IsContentWithOneRecordPerBlock) {
  run_with_inputs(1);
  for (int block = 0; block < 20; ++block) {
    run_with_inputs(1);
    const OutputSample out = run(199);
    ASSERT_FALSE(any(out.status, Status::input_missing | Status::drift_held));
  }
}

TEST_F(ExtensionTest, HasNoValidRateBeforeItsInputsHaveCome) {
  EXPECT_TRUE(any(run(1000).status, Status::drift_given_up));
  EXPECT_FALSE(run(1).compensated_valid());
  run_with_inputs(200);
  EXPECT_TRUE(run_with_inputs(1).compensated_valid());
}

TEST_F(ExtensionTest, HoldsTheDriftWithoutAnInputThenGivesItUpThenRecovers) {
  const fog::Rate drift = run_with_inputs(400).drift;
  const auto run_without_field = [&](int blocks) {
    OutputSample last;
    for (int i = 0; i < 200 * blocks; ++i) {
      take(fog::Input::temperature2, 26);
      last = run(1);
    }
    return last;
  };
  OutputSample out = run_without_field(2);
  EXPECT_TRUE(any(out.status, Status::input_missing));
  EXPECT_TRUE(any(out.status, Status::drift_held));
  EXPECT_TRUE(out.compensated_valid());
  EXPECT_EQ(out.drift, drift);
  out = run_without_field(60);
  EXPECT_TRUE(any(out.status, Status::drift_given_up));
  out = run_with_inputs(401);
  EXPECT_FALSE(any(out.status, Status::drift_given_up | Status::input_missing));
  EXPECT_TRUE(out.compensated_valid());
}

TEST_F(ExtensionTest, TakesAnImpossibleSecondTemperatureForAMissingOne) {
  run_with_inputs(400);
  OutputSample out;
  for (int i = 0; i < 400; ++i) {
    take(fog::Input::temperature2, -300);
    take(fog::Input::magnetic, 50);
    out = run(1);
  }
  EXPECT_TRUE(any(out.status, Status::input_missing));
}

TEST_F(CompensatorTest, WarmUpGoesOnThroughATemperatureHoldAndARestartOfTheModel) {
  model_.terms = {fog::test::natural_term("warm_up", {100}, {10})};
  model_.network = {};
  restart();
  run(200 * 50);
  for (int i = 0; i < 200 * 100; ++i) {  // longer than the hold: the model starts anew
    SensorSample in = sample();
    in.temperature_valid = false;
    send(in);
  }
  const OutputSample out = run(201);
  EXPECT_TRUE(any(out.status, Status::thermal_settling));
  EXPECT_NEAR(std::ldexp(out.drift.raw(), -10), 10 * std::exp(-151 / 100.0), 2.0 / 1024);
}

TEST_F(CompensatorTest, WarmUpCountsLostSamplesAsTimeThatPasses) {
  model_.terms = {fog::test::natural_term("warm_up", {100}, {10})};
  model_.network = {};
  restart();
  run(200 * 5);
  sequence_ = static_cast<std::uint16_t>(sequence_ + 200 * 20);
  const OutputSample out = run(201);
  EXPECT_NEAR(std::ldexp(out.drift.raw(), -10), 10 * std::exp(-26 / 100.0), 2.0 / 1024);
}

TEST_F(CompensatorTest, ScaleFactorFollowsTheMeasuredRateOfTheLastBlock) {
  model_.terms = {fog::test::natural_term("scale_factor_temperature", {}, {300})};
  model_.network = {};
  restart();
  OutputSample out;
  for (int i = 0; i < 401; ++i) {
    SensorSample in = sample();
    in.temperature_q16 = 60 * kDegree;
    in.rate_counts = (360000 + i % 7) * 1024;  // 100 deg/s
    out = send(in);
  }
  EXPECT_NEAR(std::ldexp(out.drift.raw(), -10), 360003 * 300e-6 * 40, 60);  // 1.2 % of it is k W dT
}

}  // namespace
