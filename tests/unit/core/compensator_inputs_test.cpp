#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "model/drift_model.hpp"
#include "support/typical_effects.hpp"
#include "unit/core/compensator_fixture.hpp"

// Inputs of the drift model beside the temperature: extension records, time, the measured rate.
namespace {

using fog::OutputSample;
using fog::SensorSample;
using fog::Status;
using fog::test::CompensatorTest;
using fog::test::kConfirmed;
using fog::test::kDegree;

// A model that needs a second temperature and the field, at 200 Hz.
class ExtensionTest : public CompensatorTest {
 protected:
  ExtensionTest() {
    for (const char* name : {"axial_gradient", "magnetic"}) {
      for (const fogcomp::model::EffectTerm& term : fog::test::typical_terms()) {
        if (term.name == name) model_.terms.push_back(term);
      }
    }
    settings_.extension = true;
    restart();
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
  fogcomp::model::RealDriftModel real(model_, 1);
  fogcomp::model::RealBlock block{25};
  block[fog::Input::temperature2] = 26;
  block[fog::Input::magnetic] = 50;
  real.start(block);
  for (int i = 0; i < 1000; ++i) {
    const OutputSample out = run_with_inputs(1);
    ASSERT_NEAR(std::ldexp(out.drift.raw(), -10), real.drift_dph(), 2.0 / 1024);
    ASSERT_EQ(out.compensated_valid(), i >= kConfirmed);
  }
}

TEST_F(ExtensionTest, IsContentWithOneRecordPerBlock) {
  run_with_inputs(1);
  for (int block = 0; block < 20; ++block) {
    run_with_inputs(1);
    const OutputSample out = run(199);
    ASSERT_FALSE(has_any(out.status, Status::input_missing | Status::drift_held));
  }
}

TEST_F(ExtensionTest, HasNoValidRateBeforeItsInputsHaveCome) {
  EXPECT_TRUE(has_any(run(1000).status, Status::drift_given_up));
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
  EXPECT_TRUE(has_any(out.status, Status::input_missing));
  EXPECT_TRUE(has_any(out.status, Status::drift_held));
  EXPECT_TRUE(out.compensated_valid());
  EXPECT_EQ(out.drift, drift);
  out = run_without_field(60);
  EXPECT_TRUE(has_any(out.status, Status::drift_given_up));
  out = run_with_inputs(401);
  EXPECT_FALSE(has_any(out.status, Status::drift_given_up | Status::input_missing));
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
  EXPECT_TRUE(has_any(out.status, Status::input_missing));
}

// The second temperature is the coil's plus 1 degC; the coil's rises by 1.2 degC/min from 0 on.
class SecondTemperature : public ExtensionTest {
 protected:
  struct Run {
    std::vector<double> drift_dph;
    std::vector<Status> status;
  };

  // Runs until the model has settled, and 90 s longer; `second` converts the true second
  // temperature to its sensor's reading.
  template <class Second>
  Run ramp(Second second) {
    pipeline_ = std::make_unique<fogcomp::board::HostCompensator>(
        parameters_, fog::IntegrityToken::not_needed());
    Run run;
    const int seconds = static_cast<int>(parameters_.policy.settle_blocks) + 90;
    for (int i = 0; i < seconds * 200; ++i) {
      SensorSample in = sample();
      const double degc = 0 + 1e-4 * i + (i % 2) / 16.0;
      in.temperature_q16 = static_cast<std::int32_t>(degc * kDegree);
      take(fog::Input::temperature2, second(i, degc + 1));
      take(fog::Input::magnetic, 50);
      const OutputSample out = send(in);
      run.drift_dph.push_back(std::ldexp(out.drift.raw(), -10));
      run.status.push_back(out.status);
    }
    return run;
  }
  static double true_value(int /*sample*/, double degc) { return degc; }
};

TEST_F(SecondTemperature, ASpikeLeavesNoTrace) {
  const Run undisturbed = ramp(true_value);
  const Run run = ramp([](int i, double degc) { return i == 100 * 200 + 7 ? 100 : degc; });
  for (std::size_t i = 0; i < run.drift_dph.size(); ++i) {
    ASSERT_NEAR(run.drift_dph[i], undisturbed.drift_dph[i], 2.0 / 1024) << i;
  }
}

TEST_F(SecondTemperature, AFirstValueThatIsWrongLeavesNoTraceInAValidRate) {
  const Run undisturbed = ramp(true_value);
  const Run run = ramp([](int i, double degc) { return i < 20 ? 50 : degc; });
  for (std::size_t i = 0; i < run.drift_dph.size(); ++i) {
    if (has_any(run.status[i], fog::kRateInvalid | Status::thermal_settling)) continue;
    ASSERT_NEAR(run.drift_dph[i], undisturbed.drift_dph[i], 2.0 / 1024) << i;
  }
  EXPECT_FALSE(has_any(run.status.back(), fog::kRateInvalid | Status::thermal_settling));
}

TEST_F(SecondTemperature, ThatStandsStillWithItsNoiseIsMissing) {
  const Run run = ramp([](int i, double degc) { return i < 100 * 200 ? degc : 31.5; });
  EXPECT_FALSE(has_any(run.status[100 * 200], Status::input_missing));
  EXPECT_TRUE(has_any(run.status.back(), Status::input_missing));
}

TEST_F(SecondTemperature, ThatJumpsAndIsConfirmedStartsTheModelAnew) {
  const Run run = ramp([](int i, double degc) { return i < 100 * 200 ? degc : degc + 10; });
  EXPECT_TRUE(has_any(run.status[102 * 200], Status::input_missing));
  EXPECT_FALSE(has_any(run.status[120 * 200], Status::input_missing));
  EXPECT_TRUE(has_any(run.status[120 * 200], Status::thermal_settling));
  EXPECT_EQ(run.status.back() & fog::kRateInvalid, Status::none);
}

// The field was trained from 0 to 100 uT in steps of 5: half of that span beyond it is allowed.
class TrainedField : public ExtensionTest {
 protected:
  TrainedField() {
    model_.input_ranges[extension_number(fog::Input::magnetic)] =
        fogcomp::model::InputRange{{0, 100}, 5};
    settings_.extension = true;
    restart();
    run_with_field(50, 400);
  }
  OutputSample run_with_field(double field_ut, int samples) {
    OutputSample last;
    for (int i = 0; i < samples; ++i) {
      take(fog::Input::temperature2, 26);
      take(fog::Input::magnetic, field_ut + (i % 2) * 0.5);
      last = run(1);
    }
    return last;
  }
};

TEST_F(TrainedField, BeyondItsRangeIsMissing) {
  EXPECT_FALSE(has_any(run_with_field(50, 200).status, Status::input_missing));
  EXPECT_FALSE(has_any(run_with_field(149, 600).status, Status::input_missing));
  EXPECT_TRUE(has_any(run_with_field(151, 600).status, Status::input_missing));
  EXPECT_FALSE(has_any(run_with_field(-49, 600).status, Status::input_missing));
  EXPECT_TRUE(has_any(run_with_field(-51, 600).status, Status::input_missing));
}

TEST_F(TrainedField, IsNotTakenFromASpikeAndIsFromAStepThatLasts) {
  const fog::Rate drift = run_with_field(50, 200).drift;
  for (int i = 0; i < 800; ++i) {
    const bool spike = i < 80 || i == 300;  // 0.4 s, 5 ms
    EXPECT_NEAR(run_with_field(spike ? 90 : 50, 1).drift.raw(), drift.raw(), 1) << i;
  }
  EXPECT_FALSE(has_any(run_with_field(90, 800).status, Status::input_missing));
  EXPECT_GT(run_with_field(90, 1).drift, drift);
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
  EXPECT_TRUE(has_any(out.status, Status::thermal_settling));
  EXPECT_NEAR(std::ldexp(out.drift.raw(), -10), 10 * std::exp(-151 / 100.0), 2.0 / 1024);
}

TEST_F(CompensatorTest, WarmUpCountsLostSamplesAsTimeThatPasses) {
  model_.terms = {fog::test::natural_term("warm_up", {100}, {10})};
  model_.network = {};
  restart();
  run(200 * 5);
  sequence_ = static_cast<std::uint16_t>(sequence_ + 200 * 20);
  const OutputSample out = run(200 + 21);  // a step for each lost block, one a sample
  EXPECT_FALSE(has_any(out.status, Status::drift_held));
  EXPECT_NEAR(std::ldexp(out.drift.raw(), -10), 10 * std::exp(-26 / 100.0), 2.0 / 1024);
}

TEST_F(CompensatorTest, ScaleFactorIsThatOfTheCompensatedRate) {
  model_.terms = {fog::test::natural_term("scale_factor_temperature", {}, {300})};
  model_.network = {};
  restart();
  OutputSample out;
  for (int i = 0; i < 2001; ++i) {
    SensorSample in = sample();
    in.temperature_q16 = 60 * kDegree;
    in.rate_counts = (360000 + i % 7) * 1024;  // 100 deg/s
    out = send(in);
  }
  // 300 ppm/degC over 40 degC make 1.2 % of the compensated rate, the rest of 360,003.
  EXPECT_NEAR(std::ldexp(out.drift.raw(), -10), 360003 * 0.012 / 1.012, 0.1);
}

// 200 deg/s back and forth in 4 s: 314 deg/s^2. A block mean would differ by up to 300 deg/s, 0.3
// deg/s of drift.
TEST_F(CompensatorTest, ScaleFactorFollowsTheRateFromSampleToSample) {
  model_.terms = {fog::test::natural_term("scale_factor", {}, {1000}),
                  fog::test::natural_term("scale_factor_nonlinearity", {5, 200}, {20, 300, 5, 40}),
                  fog::test::natural_term("scale_factor_asymmetry", {}, {-50})};
  model_.network = {};
  restart();
  run(300);
  fogcomp::model::RealDriftModel real(model_, 1);
  real.start({});
  double worst_dph = 0;
  for (int i = 0; i < 2000; ++i) {
    const double rate_dph = 200 * 3600 * std::sin(2 * M_PI * i / 800);
    fogcomp::model::RealBlock block;
    block.input_rate = rate_dph;
    real.see_rate(block);
    SensorSample in = sample();
    in.rate_counts = static_cast<std::int32_t>(std::lround((rate_dph + real.drift_dph()) * 1024));
    const OutputSample out = send(in);
    ASSERT_TRUE(out.compensated_valid()) << i;
    worst_dph = std::max(worst_dph, std::abs(std::ldexp(out.compensated.raw(), -10) - rate_dph));
  }
  // 5,700 deg/h between two samples, of which 2e-3 of 2e-3.
  EXPECT_LE(worst_dph, 0.03);
}

// Effects do not follow an invalid rate.
TEST_F(CompensatorTest, ASampleThatIsNotValidDoesNotMoveTheScaleFactor) {
  model_.terms = {fog::test::natural_term("scale_factor", {}, {1000})};
  model_.network = {};
  restart();
  run(300);
  SensorSample bad = sample();
  bad.rate_counts = 500 * 3600 * 1024;
  bad.gyro_valid = false;
  send(bad);
  EXPECT_NEAR(std::ldexp(send(sample()).drift.raw(), -10), std::ldexp(run(1).drift.raw(), -10),
              1.0 / 1024);
}

}  // namespace
