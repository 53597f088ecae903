// State that outlives a restart of the board: it is used only if it is intact, and the pipeline
// then continues exactly as the one that wrote it.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <random>

#include "core/health/kept_words.hpp"
#include "support/typical_effects.hpp"
#include "unit/core/compensator_fixture.hpp"

namespace {

using fog::OutputSample;
using fog::SensorSample;
using fog::Status;
using Kept = fog::KeptWords<8>;

constexpr std::uint32_t kOwner = 0x12345678;

// Uninitialised memory.
struct Memory {
  alignas(Kept) std::array<unsigned char, sizeof(Kept)> bytes{};
  Kept& kept() { return *reinterpret_cast<Kept*>(bytes.data()); }
};

Memory sealed(std::size_t size) {
  Memory memory;
  for (std::uint32_t i = 0; i < size; ++i) memory.kept().words()[i] = 0xA5A50000U + i;
  memory.kept().seal(size, kOwner);
  return memory;
}

TEST(KeptWords, AreBelievedAsTheyWereSealedAndByTheirOwnerAlone) {
  EXPECT_TRUE(sealed(8).kept().are_intact(kOwner));
  EXPECT_TRUE(sealed(1).kept().are_intact(kOwner));
  EXPECT_FALSE(sealed(0).kept().are_intact(kOwner)) << "there are none";
  EXPECT_FALSE(sealed(8).kept().are_intact(kOwner + 1)) << "another image";
  Memory memory = sealed(8);
  memory.kept().forget();
  EXPECT_FALSE(memory.kept().are_intact(kOwner));
}

TEST(KeptWords, AreNotBelievedWithAnyBitFlipped) {
  const Memory good = sealed(8);
  for (std::size_t bit = 0; bit < 8 * sizeof(Kept); ++bit) {
    Memory memory = good;
    memory.bytes[bit / 8] = static_cast<unsigned char>(memory.bytes[bit / 8] ^ (1U << (bit % 8)));
    ASSERT_FALSE(memory.kept().are_intact(kOwner)) << "bit " << bit;
  }
}

TEST(KeptWords, NothingIsBelievedOfWhatPowerOnLeaves) {
  std::mt19937 random(1);
  for (int i = 0; i < 10'000; ++i) {
    Memory memory;
    for (unsigned char& byte : memory.bytes) {
      byte = static_cast<unsigned char>(i == 0 ? 0 : i == 1 ? 0xFF : random());
    }
    if (i > 1) memory.bytes[4] = memory.bytes[5] = memory.bytes[6] = memory.bytes[7] = 0;
    if (i > 1) memory.bytes[4] = static_cast<unsigned char>(1 + i % 8);  // a size that can be
    ASSERT_FALSE(memory.kept().are_intact(kOwner)) << i;
  }
}

// All effects, an expression with states and a network of lags, in a ramp.
class KeptState : public fog::test::CompensatorTest {
 protected:
  using Pipeline = fogcomp::board::HostCompensator;

  KeptState() {
    model_ = fog::test::all_effects_model();
    model_.terms.push_back(fog::test::written_term("late = lag(T,300)-play(T,4)"));
    model_.network = fog::test::network_of({{fog::NetworkInput::temperature, 10, 51, 0},
                                            {fog::NetworkInput::lagged_temperature, 10, 50, 600}});
    settings_.extension = true;
    restart();
  }

  // All that comes with one sample.
  static OutputSample give(Pipeline& pipeline, const SensorSample& sample) {
    constexpr std::array<std::int32_t, fog::kExtensionInputs> kValues{25, 20, 100, 5, 1};
    for (std::size_t i = 0; i < kValues.size(); ++i) {
      pipeline.take({fog::extension_input(i), fog::ExtensionValue::from_raw(kValues[i] << 16)});
    }
    return pipeline.process(sample);
  }
  SensorSample next() {
    SensorSample now = sample();
    now.temperature_q16 += ++samples_ * 4;  // 3 degC/min
    return now;
  }
  // As the product's main loop does. Returns the size of the state.
  std::size_t run_until_kept(int samples) {
    for (int i = 0; i < samples || !pipeline_->ended_block(); ++i) give(*pipeline_, next());
    give(*pipeline_, next());
    return pipeline_->keep(state_.data());
  }
  std::unique_ptr<Pipeline> resumed(bool was_short) {
    auto pipeline = std::make_unique<Pipeline>(parameters_, fog::IntegrityToken::not_needed());
    pipeline->resume(state_.data(), was_short);
    return pipeline;
  }

  std::array<std::uint32_t, Pipeline::kMaxStateWords> state_{};
  std::int32_t samples_ = 0;
};

TEST_F(KeptState, APipelineThatGoesOnFromItHasTheDriftsOfTheOneThatWroteIt) {
  const std::size_t words = run_until_kept(200 * 60);
  ASSERT_GT(words, 0U);
  ASSERT_LE(words, state_.size());
  const auto after_restart = resumed(true);
  for (int i = 0; i < 200 * 30; ++i) {
    const SensorSample now = next();
    const OutputSample expected = give(*pipeline_, now);
    const OutputSample drift = give(*after_restart, now);
    ASSERT_EQ(drift.drift.raw(), expected.drift.raw()) << i;
    ASSERT_EQ(drift.status & Status::thermal_settling, expected.status & Status::thermal_settling);
    ASSERT_EQ(drift.status & Status::history_unknown, expected.status & Status::history_unknown);
    ASSERT_EQ(drift.status & fog::kRateInvalid, Status::none) << i;
  }
}

// The samples lost in the meantime are a gap like any other.
TEST_F(KeptState, ARestartIsAGapInTheSamples) {
  ASSERT_GT(run_until_kept(200 * 60), 0U);
  const auto after_restart = resumed(true);
  constexpr double kBoundLsb = 0.005 * (1 << fog::Rate::fractional_bits);
  for (int i = 0; i < 200 * 5; ++i) next();
  for (int i = 0; i < 200 * 30; ++i) {
    const SensorSample now = next();
    const OutputSample expected = give(*pipeline_, now);
    const OutputSample drift = give(*after_restart, now);
    if (i < 400) continue;  // the hold ends with the next block, and is bridged
    ASSERT_NEAR(drift.drift.raw(), expected.drift.raw(), kBoundLsb) << i;
    ASSERT_EQ(drift.status & Status::drift_held, Status::none) << i;
  }
}

TEST_F(KeptState, AResetThatMayHaveBeenLongStartsTheThermalStateAnewButNotTheTime) {
  model_.terms = {fog::test::written_term("late = lag(T,300)-T"),
                  fog::test::natural_term("warm_up", {3000}, {0.5})};
  model_.network = {};
  restart();
  ASSERT_GT(run_until_kept(200 * 60), 0U);
  const auto after_restart = resumed(false);
  const OutputSample first = give(*after_restart, next());
  EXPECT_EQ(first.status & Status::thermal_settling, Status::thermal_settling);
  restart();
  const OutputSample cold = give(*pipeline_, next());
  EXPECT_NE(first.drift.raw(), cold.drift.raw()) << "the time since power-on went on";
}

TEST_F(KeptState, NothingIsKeptOfAModelThatHasNoDriftToTrust) {
  for (int i = 0; i < 50; ++i) give(*pipeline_, next());  // not confirmed yet
  EXPECT_EQ(pipeline_->keep(state_.data()), 0U);
  ASSERT_GT(run_until_kept(400), 0U);
  for (int i = 0; i < 200 * 70; ++i) {  // longer than may be held
    SensorSample now = next();
    now.temperature_valid = false;
    give(*pipeline_, now);
  }
  EXPECT_EQ(pipeline_->keep(state_.data()), 0U);
}

// A reading that the coil cannot have reached discards the kept state.
TEST_F(KeptState, IsGivenUpWhereTheTemperatureIsAnother) {
  ASSERT_GT(run_until_kept(200 * 300), 0U);
  const auto after_restart = resumed(true);
  OutputSample last;
  for (int i = 0; i < 200 * 40; ++i) {
    SensorSample now = next();
    now.temperature_q16 -= 20 * fog::test::kDegree;
    last = give(*after_restart, now);
  }
  EXPECT_EQ(last.status & Status::thermal_settling, Status::thermal_settling);
}

}  // namespace
