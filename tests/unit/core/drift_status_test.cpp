// spec/pipeline.md, "Course of the model": how long a drift is held, when it is given up, and when
// it has settled.
#include <gtest/gtest.h>

#include <cstdint>

#include "core/compensation/drift_model.hpp"

namespace {

using fog::Status;
using fog::Temperature;
using Model = fog::DriftModel<fog::kAllEffects, fog::kAllExpressions, fog::kAllNetworkInputs>;

class DriftStatus : public testing::Test {
 protected:
  DriftStatus() {
    thermal_.derivative.decay = decltype(thermal_.derivative.decay)::from_raw(1 << 29);
    thermal_.derivative.rate_gain = decltype(thermal_.derivative.rate_gain)::from_raw(1 << 24);
    thermal_.min = fog::from_integer<Temperature>(-40);
    thermal_.max = fog::from_integer<Temperature>(60);
    policy_.hold_blocks = 5;
    policy_.accurate_blocks = INT32_MAX;
    policy_.settle_blocks = 3;
    effects_.coefficient_fraction = 20;
  }
  Model make() const { return {thermal_, effects_, expressions_, network_, policy_}; }
  static fog::BlockMeans<fog::BoardNumbers> at(std::int32_t raw) {
    return {Temperature::from_raw(raw)};
  }

  fog::ThermalParameters<fog::BoardNumbers> thermal_;
  fog::EffectsParameters effects_;
  fog::ExpressionParameters expressions_;
  fog::NetworkParameters network_;
  fog::DriftPolicy policy_;
};

TEST_F(DriftStatus, NoDriftIsNotAGoodOne) {
  Model model = make();
  EXPECT_FALSE(model.started());
  EXPECT_EQ(model.status(), Status::drift_given_up | Status::thermal_settling);
  model.step(at(0));  // a start
  EXPECT_TRUE(model.started());
  EXPECT_EQ(model.status(), Status::thermal_settling);
}

TEST_F(DriftStatus, SettlesAfterAsManyBlocksAsThePolicySays) {
  Model model = make();
  model.start(at(0));
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(model.status(), Status::thermal_settling) << i;
    model.step(at(0));
  }
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(model.status(), Status::none) << i;
    model.step(at(0));
  }
}

TEST_F(DriftStatus, IsHeldForAsManyBlocksAsThePolicySaysThenGivenUpThenStartedAnew) {
  Model model = make();
  model.start(at(0));
  for (int i = 0; i < 3; ++i) model.step(at(0));
  model.hold(2);
  EXPECT_EQ(model.status(), Status::drift_held);
  model.hold(3);
  EXPECT_EQ(model.status(), Status::drift_held);
  model.step(at(0));  // in time: it goes on
  EXPECT_EQ(model.status(), Status::thermal_settling);
  for (int i = 0; i < 3; ++i) model.step(at(0));
  EXPECT_EQ(model.status(), Status::none);
  model.hold(5);
  EXPECT_EQ(model.status(), Status::drift_held);
  model.hold(1);
  EXPECT_EQ(model.status(), Status::drift_held | Status::drift_given_up);
  model.step(at(0));
  EXPECT_EQ(model.status(), Status::thermal_settling);
  model.hold(6);
  EXPECT_EQ(model.status(), Status::drift_held | Status::drift_given_up | Status::thermal_settling);
}

// Three times the hold, and no longer than after a start.
TEST_F(DriftStatus, SettlesAfterAHoldForThreeTimesAsLong) {
  policy_.settle_blocks = 12;
  for (const auto& [held, unsure] : {std::pair{1U, 3}, {2U, 6}, {3U, 9}, {4U, 12}, {5U, 12}}) {
    Model model = make();
    model.start(at(0));
    for (int i = 0; i < 12; ++i) model.step(at(0));
    model.hold(held);
    model.step(at(0));
    for (int i = 0; i < unsure; ++i) {
      EXPECT_EQ(model.status(), Status::thermal_settling) << held << " " << i;
      model.step(at(0));
    }
    EXPECT_EQ(model.status(), Status::none) << held;
  }
}

// The steps of the bridge are no time in which lags could forget.
TEST_F(DriftStatus, TimeUnknown_AcrossAHold_SettlesAnew) {
  policy_.settle_blocks = 30;
  for (const std::uint32_t held : {0U, 1U, 5U}) {
    Model model = make();
    model.start(at(0));
    for (int i = 0; i < 30; ++i) model.step(at(0));
    EXPECT_EQ(model.status(), Status::none);
    model.hold(held);
    model.unsettle();
    for (std::uint32_t i = 0; i < 30; ++i) {
      model.step(at(0));
      EXPECT_EQ(has_any(model.status(), Status::thermal_settling), i + 1 < 30) << held << " " << i;
    }
    model.step(at(0));
    EXPECT_EQ(model.status(), Status::none) << held;
  }
}

// A network is held at the ends of its training, like an expression.
TEST_F(DriftStatus, NetworkInput_OutsideItsRange_Flagged) {
  policy_.settle_blocks = 0;
  const std::int32_t neuron[fog::kNeuronWords] = {};
  network_.neurons = {neuron, fog::kNeuronWords};
  network_.input_count = 1;
  for (const fog::NetworkInput signal :
       {fog::NetworkInput::input_rate, fog::NetworkInput::elapsed}) {
    const bool is_time = signal == fog::NetworkInput::elapsed;
    network_.inputs[0].signal = signal;
    network_.inputs[0].centre = 10;
    network_.inputs[0].half_range = 50;
    Model model = make();
    fog::BlockMeans<fog::BoardNumbers> means = at(0);
    model.start(means);
    EXPECT_EQ(model.status(), Status::none);
    for (const std::int32_t value : {60, 61, -40, -41}) {
      if (is_time) means.elapsed = fog::Elapsed::from_raw(value);
      if (!is_time) means.input_rate = fog::Rate::from_raw(value);
      model.step(means);
      const bool beyond = value == 61 || value == -41;
      EXPECT_EQ(model.status(), beyond && !is_time ? Status::temperature_clamped : Status::none)
          << value;
    }
  }
}

TEST_F(DriftStatus, IsHeldUntilTheModelHasCaughtUpStepByStep) {
  const std::int32_t coefficient = 1 << 20;
  effects_.by_id[2].coefficients = {&coefficient, 1};  // temperature_rate
  constexpr std::int32_t kPerBlock = 3000;
  Model whole = make();
  Model model = make();
  whole.start(at(0));
  model.start(at(0));
  std::int32_t raw = 0;
  const auto step_whole = [&] { whole.step(at(raw += kPerBlock)); };
  step_whole();
  model.step(at(raw));
  const fog::Rate held = model.drift();
  for (int i = 0; i < 5; ++i) step_whole();
  model.hold(4);
  model.take(at(raw));
  const auto next_sample = [&] {
    model.catch_up();
    model.update_rate({}, true);
  };
  for (int i = 0; i < 4; ++i) {
    next_sample();
    EXPECT_EQ(model.drift(), held);
    EXPECT_TRUE(has_any(model.status(), Status::drift_held));
  }
  next_sample();
  EXPECT_EQ(model.drift(), whole.drift());
  EXPECT_EQ(model.status(), Status::thermal_settling);
  next_sample();
  EXPECT_EQ(model.drift(), whole.drift()) << "nothing is due";
}

// Blocks lost while the model catches up become part of the next bridge.
TEST_F(DriftStatus, AHoldDuringTheCatchingUpIsHeldAsWell) {
  Model model = make();
  model.start(at(0));
  for (int i = 0; i < 3; ++i) model.step(at(0));
  model.hold(3);
  model.take(at(4000));
  model.catch_up();
  model.hold(1);
  for (int i = 0; i < 3; ++i) model.catch_up();
  EXPECT_TRUE(has_any(model.status(), Status::drift_held)) << "the block that was lost meanwhile";
  model.hold(4);
  EXPECT_FALSE(has_any(model.status(), Status::drift_given_up));
  model.hold(1);
  EXPECT_TRUE(has_any(model.status(), Status::drift_given_up));
  model.step(at(4000));
  EXPECT_EQ(model.status(), Status::thermal_settling);
}

// One step a block, and a bridge to make besides: the drift is of the time before it.
TEST_F(DriftStatus, UnfinishedBridge_BlocksThatCome_HeldTillGivenUp) {
  policy_.accurate_blocks = 3;
  Model model = make();
  model.start(at(0));
  for (int i = 0; i < 3; ++i) model.step(at(0));
  model.hold(1);
  for (std::uint32_t held = 1; held <= policy_.hold_blocks; ++held) {
    model.take(at(4000));
    model.catch_up();
    EXPECT_EQ(model.status(), held > policy_.accurate_blocks
                                  ? Status::drift_held | Status::drift_outdated
                                  : Status::drift_held)
        << held;
  }
  model.take(at(4000));
  EXPECT_EQ(model.status(), Status::thermal_settling) << "it has started anew";
}

TEST_F(DriftStatus, StaysGivenUpHoweverLongNothingComes) {
  policy_.hold_blocks = INT32_MAX;
  Model model = make();
  model.start(at(0));
  for (const std::uint32_t blocks : {0x7FFFFFFFU, 0x7FFFFFFFU, 5U, 0x7FFFFFFFU, 0x7FFFFFFFU}) {
    model.hold(blocks);
    EXPECT_TRUE(has_any(model.status(), Status::drift_held));
  }
  EXPECT_TRUE(has_any(model.status(), Status::drift_given_up));
  model.hold(7);
  EXPECT_TRUE(has_any(model.status(), Status::drift_given_up));
}

TEST_F(DriftStatus, ATemperatureIsClampedBeyondTheTrainedRangeToTheLsb) {
  policy_.settle_blocks = 0;
  Model model = make();
  for (const std::int32_t sign : {1, -1}) {
    const std::int32_t end = (sign > 0 ? 60 : -40) * 65536;
    model.start(at(end));
    EXPECT_EQ(model.status(), Status::none);
    model.step(at(end + sign));
    EXPECT_EQ(model.status(), Status::temperature_clamped);
    model.step(at(end));
    EXPECT_EQ(model.status(), Status::none);
  }
}

// Radius 3 degC: the branch is unknown until the temperature has moved through 6 degC.
TEST_F(DriftStatus, TheHistoryOfALoopIsUnknownForTwiceItsRadius) {
  policy_.settle_blocks = 0;
  const std::int32_t coefficient = 1 << 20;
  const std::int32_t constants[] = {3 << 22, (1 << 29) / 3, 0, 0};
  effects_.by_id[8].constants = constants;
  effects_.by_id[8].coefficients = {&coefficient, 1};
  constexpr std::int32_t kOneDegree = 65536;
  for (const std::int32_t sign : {1, -1}) {
    Model model = make();
    model.start(at(0));
    EXPECT_EQ(model.status(), Status::history_unknown);
    model.step(at(sign * 4 * kOneDegree));
    model.step(at(-sign * 2 * kOneDegree + sign));
    EXPECT_EQ(model.status(), Status::history_unknown);
    model.step(at(-sign * 2 * kOneDegree));
    EXPECT_EQ(model.status(), Status::none);
    model.step(at(0));
    EXPECT_EQ(model.status(), Status::none) << "for good";
    model.start(at(0));
    EXPECT_EQ(model.status(), Status::history_unknown);
  }
}

TEST_F(DriftStatus, TheRateIsClampedTo32DegreesAMinute) {
  const std::int32_t coefficient = 1 << 20;
  effects_.by_id[2].coefficients = {&coefficient, 1};  // temperature_rate alone
  for (const std::int32_t sign : {1, -1}) {
    Model model = make();
    model.start(at(0));
    EXPECT_EQ(model.drift(), fog::Rate{});
    model.step(at(sign * 1024 * 65536));
    const fog::Rate max = model.drift();
    EXPECT_NE(max, fog::Rate{});
    Model further = make();
    further.start(at(0));
    further.step(at(sign * 2048 * 65536));
    EXPECT_EQ(further.drift(), max);
  }
}

// Lags have seen another temperature than there was.
TEST_F(DriftStatus, TemperatureClamped_BackInRange_FlagLastsAsLags) {
  Model model = make();
  model.start(at(0));
  for (int i = 0; i < 10; ++i) model.step(at(0));
  model.step(at(60 * 65536 + 1));
  for (std::uint32_t i = 0; i < policy_.settle_blocks; ++i) {
    model.step(at(60 * 65536));
    EXPECT_EQ(model.status(), Status::temperature_clamped) << i;
  }
  model.step(at(60 * 65536));
  EXPECT_EQ(model.status(), Status::none);
}

TEST_F(DriftStatus, TemperatureRate_AtItsLimit_Flagged) {
  policy_.settle_blocks = 0;
  thermal_.derivative.rate_gain = decltype(thermal_.derivative.rate_gain)::from_raw(1 << 28);
  Model model = make();
  model.start(at(0));
  Status seen = Status::none;
  for (int i = 0; i < 5; ++i) {
    model.step(at(i * 20 * 65536 - 40 * 65536));
    seen = model.status();
  }
  EXPECT_EQ(seen, Status::temperature_clamped);
}

// A signal outside the range of the training is held at its end; the time may be.
TEST_F(DriftStatus, ExpressionSignal_OutsideItsRange_Flagged) {
  policy_.settle_blocks = 0;
  const std::int32_t coefficient = 1;
  expressions_.coefficients = {&coefficient, 1};
  for (const bool is_time : {false, true}) {
    const std::int32_t program[] = {is_time ? 2 << 8 : 3 << 8, -50, 50, 20};
    expressions_.program = {program, 4};
    Model model = make();
    fog::BlockMeans<fog::BoardNumbers> means = at(0);
    model.start(means);
    EXPECT_EQ(model.status(), Status::none);
    for (const std::int32_t value : {50, 51, -50, -51}) {
      if (is_time) means.elapsed = fog::Elapsed::from_raw(value);
      if (!is_time) means.input_rate = fog::Rate::from_raw(value);
      model.step(means);
      const bool beyond = value == 51 || value == -51;
      EXPECT_EQ(model.status(), beyond && !is_time ? Status::temperature_clamped : Status::none)
          << value;
    }
  }
}

class LoopStatus : public DriftStatus {
 protected:
  LoopStatus() {
    policy_.settle_blocks = 0;
    policy_.accurate_blocks = 1;
    effects_.by_id[8].constants = constants_;
    effects_.by_id[8].coefficients = {&coefficient_, 1};
  }
  // Through twice the radius of 3 degC, so that the history is known.
  void learn_history(Model& model) {
    model.step(at(4 * 65536));
    model.step(at(-2 * 65536));
    EXPECT_EQ(model.status(), Status::none);
  }

  const std::int32_t coefficient_ = 1 << 20;
  const std::int32_t constants_[4] = {3 << 22, (1 << 29) / 3, 0, 0};
};

TEST_F(LoopStatus, TurnWithinAHold_BeyondAccuracy_HistoryUnknown) {
  for (const std::uint32_t held : {1U, 2U, 5U}) {
    Model model = make();
    model.start(at(0));
    learn_history(model);
    model.hold(held);
    model.step(at(-2 * 65536));
    EXPECT_EQ(has_any(model.status(), Status::history_unknown), held > policy_.accurate_blocks);
    for (int i = 0; i < 10; ++i) model.step(at(-2 * 65536));
    EXPECT_EQ(has_any(model.status(), Status::history_unknown), held > policy_.accurate_blocks);
    learn_history(model);
  }
}

TEST_F(LoopStatus, TemperatureClamped_BackInRange_HistoryUnknown) {
  Model model = make();
  model.start(at(0));
  learn_history(model);
  model.step(at(61 * 65536));
  for (int i = 0; i < 10; ++i) {
    model.step(at(58 * 65536));
    EXPECT_EQ(model.status(), Status::history_unknown);
  }
  model.step(at(50 * 65536));
  EXPECT_EQ(model.status(), Status::none);
}

// Nobody knows how long the power was off.
TEST_F(DriftStatus, WarmUp_AfterPowerOn_UnknownForFiveTimeConstants) {
  policy_.settle_blocks = 0;
  const std::int32_t coefficient = 1 << 20;
  const std::int32_t constant = INT32_MAX / 100;
  effects_.by_id[11].constants = &constant;
  effects_.by_id[11].coefficients = {&coefficient, 1};
  Model model = make();
  fog::BlockMeans<fog::BoardNumbers> means = at(0);
  model.start(means);
  for (std::int32_t blocks = 1; blocks < 1000; ++blocks) {
    means.elapsed = fog::Elapsed::from_raw(blocks);
    model.step(means);
    ASSERT_EQ(model.status(), blocks > 500 ? Status::none : Status::history_unknown) << blocks;
  }
}

}  // namespace
