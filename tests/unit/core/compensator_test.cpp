#include "core/pipeline/compensator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "core/bytes/byte_order.hpp"
#include "core/pipeline/silence_clock.hpp"
#include "model/drift_model.hpp"
#include "support/overflow_guard.hpp"
#include "unit/core/compensator_fixture.hpp"

namespace {

using fog::OutputSample;
using fog::SensorSample;
using fog::Status;
using fog::test::CompensatorTest;
using fog::test::kConfirmed;
using fog::test::kDegree;

TEST_F(CompensatorTest, SubtractsTheModelledDriftFromTheFirstSampleOn) {
  fogcomp::model::RealDriftModel real(model_, 1);
  real.start({25});
  for (int i = 0; i < 1000; ++i) {
    const SensorSample in = sample();
    const OutputSample out = send(in);
    ASSERT_NEAR(std::ldexp(out.drift.raw(), -10), real.drift_dph(), 2.0 / 1024);
    ASSERT_EQ(out.compensated.raw(), in.rate_counts - out.drift.raw());
    ASSERT_EQ(out.compensated_valid(), i >= kConfirmed);
  }
}

// Before its first conversion a sensor outputs 0 degC, or any register value.
TEST_F(CompensatorTest, ABadFirstTemperatureLeavesNoTrace) {
  fogcomp::model::RealDriftModel real(model_, 1);
  real.start({25});
  for (const int bad : {1, 7, 99}) {
    restart();
    for (int i = 0; i < 1000; ++i) {
      SensorSample in = sample();
      if (i < bad) in.temperature_q16 = 0;
      const OutputSample out = send(in);
      ASSERT_EQ(out.compensated_valid(), i >= bad + kConfirmed) << i;
      if (i < bad) continue;
      ASSERT_NEAR(std::ldexp(out.drift.raw(), -10), real.drift_dph(), 2.0 / 1024)
          << bad << " " << i;
    }
  }
}

TEST_F(CompensatorTest, NoRateIsValidWhileTheFirstTemperaturesDisagree) {
  for (int i = 0; i < 1000; ++i) {
    SensorSample in = sample();
    if (i % kConfirmed == 0) in.temperature_q16 = i * kDegree / 100;
    EXPECT_FALSE(send(in).compensated_valid()) << i;
  }
}

// A sensor that was wrong for long enough to be accepted, then right.
TEST_F(CompensatorTest, ATemperatureThatIsAcceptedAfterAJumpStartsTheModelAnew) {
  const auto run_at = [&](double degc, int samples) {
    OutputSample out;
    for (int i = 0; i < samples; ++i) {
      SensorSample in = sample();
      in.temperature_q16 = static_cast<std::int32_t>(degc * kDegree);
      out = send(in);
    }
    return out;
  };
  run_at(0, 200 * 220);
  EXPECT_EQ(run_at(25, 200 * 20).status,
            Status::temperature_invalid | Status::temperature_jump | Status::drift_held);
  const OutputSample out = run_at(25, 200 * 5);
  EXPECT_EQ(out.status, Status::thermal_settling);
  fogcomp::model::RealDriftModel real(model_, 1);
  real.start({25});
  EXPECT_NEAR(std::ldexp(out.drift.raw(), -10), real.drift_dph(), 2.0 / 1024);
}

TEST_F(CompensatorTest, DriftOfABlockCountsFromTheNextBlockOn) {
  run(200);
  const fog::Rate before = run(1).drift;
  OutputSample last;
  for (int i = 1; i < 200; ++i) {
    SensorSample warm = sample();
    warm.temperature_q16 = 26 * kDegree;
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
    EXPECT_TRUE(has_any(out.status, Status::rate_out_of_range));
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
  EXPECT_TRUE(has_any(out.status, Status::temperature_invalid | Status::drift_held));
  EXPECT_TRUE(out.compensated_valid());
  EXPECT_EQ(out.drift, drift);
  out = send_without_temperature(60);
  EXPECT_TRUE(has_any(out.status, Status::drift_given_up));
  EXPECT_FALSE(out.compensated_valid());
  out = run(401);
  EXPECT_FALSE(has_any(out.status, Status::drift_given_up | Status::drift_held));
  EXPECT_TRUE(has_any(out.status, Status::thermal_settling));
  EXPECT_TRUE(out.compensated_valid());
}

TEST_F(CompensatorTest, TakesAnImpossibleTemperatureForAMissingOne) {
  run(10);
  for (const std::int32_t degc : {-71, 131, 32767, -32768}) {
    SensorSample in = sample();
    in.temperature_q16 = degc * kDegree;
    const OutputSample out = send(in);
    EXPECT_TRUE(has_any(out.status, Status::temperature_invalid)) << degc;
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
  EXPECT_TRUE(has_any(out.status, Status::temperature_clamped));
  EXPECT_TRUE(out.compensated_valid());
}

TEST_F(CompensatorTest, FlagsLostAndRepeatedSamplesAndKeepsTime) {
  run(150);
  sequence_ = static_cast<std::uint16_t>(sequence_ + 100);  // the block ends within the gap
  SensorSample in = sample();
  in.temperature_q16 = 26 * kDegree;
  EXPECT_TRUE(has_any(send(in).status, Status::sequence_gap));
  EXPECT_FALSE(has_any(run(1).status, Status::sequence_gap));
  --sequence_;  // the same number again
  EXPECT_TRUE(has_any(run(1).status, Status::sequence_gap));
}

// In a turn the denoised rate stands for another time than its delay says, until all of the
// denoiser's samples have come after the gap; no longer.
TEST_F(CompensatorTest, LostSamples_Turning_DenoisedMarkedForDelay) {
  constexpr std::int32_t kPerSample = 180 * 1024;  // 10 deg/s^2
  constexpr std::int32_t kBound = 360 * 1024;      // 0.1 deg/s
  const auto delay = static_cast<int>(fog::denoise_delay(16, 5));
  std::int32_t time = 0;
  const auto turn = [&] {
    ++time;
    SensorSample in = sample();
    in.rate_counts += time * kPerSample;
    return send(in);
  };
  for (int lost : {1, 2, 180}) {
    for (int i = 0; i < 1500; ++i) {
      const OutputSample out = turn();
      if (!out.denoised_valid() || has_any(out.status, Status::denoiser_filling)) continue;
      ASSERT_NEAR(out.denoised.raw(), (time - delay) * kPerSample, kBound) << lost << " " << i;
    }
    sequence_ = static_cast<std::uint16_t>(sequence_ + lost);
    time += lost;
    for (int i = 0; i < delay; ++i) {
      const OutputSample out = turn();
      ASSERT_TRUE(has_any(out.status, Status::denoised_invalid)) << lost << " " << i;
      ASSERT_TRUE(out.compensated_valid()) << lost << " " << i;
    }
    EXPECT_TRUE(turn().denoised_valid()) << lost;
  }
}

TEST_F(CompensatorTest, LostSamples_KvhSequence_CountsThem) {
  settings_.output = fog::OutputSelection::kvh;
  restart();
  std::array<std::uint8_t, fog::kMaxOutputBytes> frame{};
  const auto sequence_of_next = [&] {
    for (const std::uint8_t byte : fog::encode_sensor_frame(sample())) {
      pipeline_->feed(byte, frame.data());
    }
    return int{frame[29]};
  };
  int before = sequence_of_next();
  for (const int lost : {0, 1, 5, 100}) {
    sequence_ = static_cast<std::uint16_t>(sequence_ + lost);
    const int now = sequence_of_next();
    EXPECT_EQ(now, (before + lost + 1) % 128);
    before = now;
  }
  // A silence has answered two of these.
  pipeline_->answer_silence(frame.data());
  pipeline_->answer_silence(frame.data());
  sequence_ = static_cast<std::uint16_t>(sequence_ + 10);
  EXPECT_EQ(sequence_of_next(), (before + 11) % 128);
}

// At 300 Hz, over the wrap of the clock.
TEST(SilenceClock, WithoutSamples_DueAfterTwoPeriodsThenOncePerPeriod) {
  const std::uint32_t start_ms = 0U - 5U;
  fog::SilenceClock clock(3333, start_ms);
  std::uint32_t frames = 0;
  for (std::uint32_t ms = 0; ms < 10'000; ++ms) {
    frames += clock.due(start_ms + ms) ? 1U : 0U;
    ASSERT_EQ(frames, ms < 8 ? 0 : (1000 * (ms - 7) + 3332) / 3333) << ms;
  }
}

TEST_F(CompensatorTest, RateDelay_OfDenoisedFrames_IsTheDenoisers) {
  EXPECT_EQ(pipeline_->rate_delay(), fog::denoise_delay(16, 5));
}

// However long a hold is against a block, no sample makes more than 64 steps of the model.
TEST_F(CompensatorTest, HoldOf99BlocksOfASample_CaughtUpInTwoSamples) {
  parameters_.samples_per_block = 1;
  parameters_.policy.hold_blocks = 200;
  pipeline_ = std::make_unique<fogcomp::board::HostCompensator>(parameters_,
                                                                fog::IntegrityToken::not_needed());
  std::vector<std::uint32_t> state(fogcomp::board::HostCompensator::kMaxStateWords);
  run(300);
  EXPECT_GT(pipeline_->keep(state.data()), 0U);
  sequence_ = static_cast<std::uint16_t>(sequence_ + 99);
  run(1);
  EXPECT_EQ(pipeline_->keep(state.data()), 0U);
  run(1);
  EXPECT_GT(pipeline_->keep(state.data()), 0U);
}

// The frame of a user who closes a loop: the rate of the sample that it answers.
TEST_F(CompensatorTest, KvhFrames_Undelayed_RateAndValidityOfTheSample) {
  for (const fog::OutputOptions angle : {fog::OutputOptions{0}, fog::kRotationIsAngle}) {
    settings_ = {};
    settings_.output_options = static_cast<fog::OutputOptions>(fog::kRotationIsUndelayed | angle);
    restart();
    EXPECT_EQ(pipeline_->rate_delay(), 0U);
    fog::DeltaAngle summed(parameters_.acquisition.sample_period_us);
    std::array<std::uint8_t, fog::kMaxOutputBytes> frame{};
    int valid = 0;
    int denoised_valid = 0;
    for (int i = 0; i < 200 * 215; ++i) {
      SensorSample in = sample();
      in.rate_counts += i % 1000 * 36'000;
      in.gyro_valid = i % 777 != 0;
      for (const std::uint8_t byte : fog::encode_sensor_frame(in))
        pipeline_->feed(byte, frame.data());
      const OutputSample out = pipeline_->last();
      summed.step(out.compensated);
      const std::uint32_t bits =
          angle != 0 ? summed.bits() : fog::rate_as_radians_float(out.compensated);
      std::array<std::uint8_t, 4> expected{};
      fog::store_be32(expected.data(), bits);
      ASSERT_TRUE(std::equal(expected.begin(), expected.end(), &frame[12])) << i;
      ASSERT_EQ((frame[28] & 4U) != 0, out.compensated_valid()) << i;
      valid += out.compensated_valid();
      denoised_valid += out.denoised_valid();
    }
    EXPECT_GT(valid, 900) << "from 210 s on";
    EXPECT_LT(denoised_valid, valid - 400) << "which come later";
  }
}

// A turn of one sample looks like an outlier. What the denoiser leaves out it says; the sum of all
// other outputs is that of the samples that they stand for.
TEST_F(CompensatorTest, TurnOfOneSample_LeftOut_DenoisedMarked) {
  constexpr std::int32_t kTurn = 36'000 * 1024;  // 10 deg/s for 5 ms
  const auto delay = static_cast<int>(fog::denoise_delay(16, 5));
  run(2000);
  std::int64_t marked = 0;
  std::int64_t turned = 0;
  double lost_deg = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto turns_at = [](int at) { return at >= 0 && at < 2000 && at % 200 == 0; };
    SensorSample in = sample();
    if (turns_at(i)) in.rate_counts += kTurn;
    turned += turns_at(i) ? 1 : 0;
    const OutputSample out = send(in);
    ASSERT_EQ(out.denoised_valid(), !turns_at(i - delay)) << i;
    marked += out.denoised_valid() ? 0 : 1;
    if (out.denoised_valid() && i >= delay) lost_deg += out.denoised.raw() / 1024.0 / 3600 * 0.005;
    if (!turns_at(i) && i < 3000 - delay) {
      lost_deg -= out.compensated.raw() / 1024.0 / 3600 * 0.005;
    }
  }
  EXPECT_EQ(turned, 10);
  EXPECT_EQ(marked, turned);
  EXPECT_NEAR(lost_deg, 0, 1e-4) << "of 0.5";
}

TEST_F(CompensatorTest, AGapLongerThanTheHoldGivesTheDriftUp) {
  run(400);
  sequence_ = static_cast<std::uint16_t>(sequence_ + 200 * 62);
  const OutputSample out = run(1);
  EXPECT_TRUE(has_any(out.status, Status::drift_given_up));
  EXPECT_FALSE(out.compensated_valid());
}

TEST_F(CompensatorTest, CallsAGyroStuckAfterHalfASecondOfEqualCounts) {
  run(400);
  SensorSample stuck = sample();
  for (int i = 1; i < 100; ++i) {
    EXPECT_FALSE(has_any(send(stuck).status, Status::gyro_stuck)) << i;
    ++stuck.sequence;
  }
  EXPECT_TRUE(has_any(send(stuck).status, Status::gyro_stuck));
  sequence_ = stuck.sequence;
  EXPECT_FALSE(has_any(run(1).status, Status::gyro_stuck));
}

TEST_F(CompensatorTest, AnswersEverySampleWithTheFramesOfItsModel) {
  const fog::SensorFrame frame = fog::encode_sensor_frame(sample());
  for (const auto selection :
       {fog::OutputSelection::kvh, fog::OutputSelection::compact, fog::OutputSelection::both}) {
    const fogcomp::board::BoardTable table =
        fogcomp::board::make_board_table(model_, {200, selection});
    const fog::ModelParameters parameters = fogcomp::board::read_board_table(table, "test");
    const auto pipeline = std::make_unique<fogcomp::board::HostCompensator>(
        parameters, fog::IntegrityToken::not_needed());
    std::vector<std::uint8_t> out(fog::kMaxOutputBytes);
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

// A value that a KVH frame cannot mark must not be in it.
TEST_F(CompensatorTest, NothingIsValidBeforeThereIsAMeasurement) {
  settings_ = {};
  restart();
  const int settled = 200 * 210;
  int first_rate = 0;
  int first_denoised = 0;
  for (int i = 0; first_denoised == 0 && i < settled + 2000; ++i) {
    const OutputSample out = run(1);
    const bool marked =
        (fog::encode_kvh_frame(out.temperature, fog::rate_as_radians_float(out.denoised),
                               out.denoised_valid(), 0, fog::kIntactImage)[28] &
         4U) != 0;
    ASSERT_EQ(marked, out.denoised_valid());
    if (out.compensated_valid() && first_rate == 0) first_rate = i;
    if (marked) first_denoised = i;
  }
  EXPECT_NEAR(first_rate, settled, 1);
  EXPECT_EQ(first_denoised, first_rate + 465);
}

TEST_F(CompensatorTest, AFillingDenoiserIsRefusedByItself) {
  settings_.invalidating = Status::denoiser_filling;
  restart();
  for (int i = 0; i < 1000; ++i) {
    const OutputSample out = run(1);
    EXPECT_EQ(out.compensated_valid(), i >= kConfirmed) << i;
    EXPECT_EQ(out.denoised_valid(), i >= kConfirmed + 465) << i;
  }
}

// For any model: the rate is valid exactly if none of its flags and none of the standard ones is
// set, and the denoised rate if that was so for the whole delay, and no sample lost.
TEST_F(CompensatorTest, ARateIsValidWhereNoneOfTheChosenFlagsIs) {
  for (const Status chosen :
       {Status::none, Status::temperature_invalid, Status::drift_held | Status::sequence_gap,
        Status::drift_outdated | Status::thermal_settling, fogcomp::board::kDefaultInvalidating}) {
    settings_.invalidating = chosen;
    model_.rate_range_degc_per_min = fogcomp::model::Range{-3, 3};
    restart();
    const Status refusing = chosen | fog::kRateInvalid;
    int good = 0;
    for (int i = 0; i < 200 * 400; ++i) {
      SensorSample in = sample();
      in.temperature_valid = i / 2000 != 25 && i / 12000 != 5;  // 10 s, and a minute
      if (i == 60'000) sequence_ = static_cast<std::uint16_t>(sequence_ + 1);
      const OutputSample out = send(in);
      const bool undelayed = !has_any(out.status, refusing & ~Status::denoiser_filling);
      const bool lost = has_any(out.status, Status::sequence_gap);
      good = undelayed && !lost ? good + 1 : 0;
      ASSERT_EQ(out.compensated_valid(), undelayed) << i;
      if (good > 466) {
        ASSERT_TRUE(out.denoised_valid()) << i;
      }
      if (out.denoised_valid()) {
        ASSERT_FALSE(has_any(out.status, refusing | Status::denoised_invalid)) << i;
      }
    }
  }
}

TEST_F(CompensatorTest, ADriftIsOutdatedWhenItWasHeldBeyondItsAccuracy) {
  model_.rate_range_degc_per_min = fogcomp::model::Range{-3, 3};
  model_.residual_rms_dph = 0.1;
  restart();
  const std::uint32_t accurate = parameters_.policy.accurate_blocks;
  EXPECT_GT(accurate, 1U);
  EXPECT_LT(accurate, parameters_.policy.hold_blocks);
  run(200 * 220);
  std::uint32_t held = 0;
  for (; held <= 60; ++held) {
    OutputSample out;
    for (int i = 0; i < 200; ++i) {
      SensorSample in = sample();
      in.temperature_valid = false;
      out = send(in);
    }
    if (has_any(out.status, Status::drift_outdated)) break;
  }
  EXPECT_NEAR(held, accurate + 1, 1);
  run(200 * 2);
  EXPECT_FALSE(has_any(run(1).status, Status::drift_outdated));
}

// KVH frames have no flag for lost samples: only the validity says that the drift is an old one.
TEST_F(CompensatorTest, GapBeyondTheHoldsAccuracy_FirstSample_OutdatedAndNotValid) {
  settings_ = {};
  model_.rate_range_degc_per_min = fogcomp::model::Range{-3, 3};
  model_.residual_rms_dph = 0.1;
  restart();
  run(200 * 220);
  EXPECT_TRUE(run(1).compensated_valid());
  const auto blocks = static_cast<int>(parameters_.policy.accurate_blocks) + 3;
  sequence_ = static_cast<std::uint16_t>(sequence_ + 200 * blocks);
  const OutputSample out = run(1);
  EXPECT_TRUE(has_any(out.status, Status::drift_outdated));
  EXPECT_FALSE(out.compensated_valid());
}

// An image has capacity for its own model only; the omitted parts must not matter.
template <class Image>
void expect_same_bytes(const fogcomp::model::Model& model) {
  const fogcomp::board::BoardTable table =
      fogcomp::board::make_board_table(model, {20, fog::OutputSelection::both});
  fog::ModelParameters parameters;
  ASSERT_EQ(fog::read_model(table.span(), Image::capacity, parameters), fog::ModelError::none);
  Image image(parameters, fog::IntegrityToken::not_needed());
  fogcomp::board::HostCompensator full(parameters, fog::IntegrityToken::not_needed());
  std::uint8_t from_image[fog::kMaxOutputBytes];
  std::uint8_t from_full[fog::kMaxOutputBytes];
  std::size_t sent = 0;
  const auto feed = [&](const auto& frame) {
    for (const std::uint8_t byte : frame) {
      const std::size_t size = image.feed(byte, from_image);
      ASSERT_EQ(full.feed(byte, from_full), size);
      ASSERT_TRUE(std::equal(from_image, from_image + size, from_full)) << sent;
      sent += size;
    }
  };
  for (std::uint16_t i = 0; i < 2000; ++i) {
    if (i % 7 == 0) feed(fog::encode_extension_frame({fog::Input::magnetic, {}}));
    if (i % 250 == 20) feed(std::array<std::uint8_t, 3>{0xA5, 0x5A, 0x00});
    feed(fog::encode_sensor_frame(
        {i, 700 + i % 11, (20 + i / 40) * kDegree, i % 60 != 59 && i % 800 > 9, i % 90 < 80}));
  }
  EXPECT_EQ(sent, 2000U * fog::kMaxOutputBytes);
  EXPECT_EQ(image.discarded_bytes(), 3U * 8);
  EXPECT_EQ(full.discarded_bytes(), 3U * 8);
}

constexpr fog::EffectMask kThreeEffects = 0x7;
constexpr fog::NetworkInputMask kTemperatureAndRate = 0x3;

TEST(CompensatorOfAnImage, SendsWhatTheOneWithRoomForEverythingSends) {
  expect_same_bytes<fog::Compensator<kThreeEffects, 0, kTemperatureAndRate, 16, 5>>(
      fog::test::paper_like_model());
}

template <fog::OutputSelection kOutput>
void expect_room_for_its_own_frames_alone(fog::OutputSelection other) {
  using Image = fog::Compensator<kThreeEffects, 0, kTemperatureAndRate, 16, 5, kOutput>;
  fog::ModelParameters parameters;
  for (const auto refused : {other, fog::OutputSelection::both}) {
    const fogcomp::board::BoardTable table =
        fogcomp::board::make_board_table(fog::test::paper_like_model(), {200, refused});
    EXPECT_EQ(fog::read_model(table.span(), Image::capacity, parameters),
              fog::ModelError::not_in_image);
  }
  const fogcomp::board::BoardTable table =
      fogcomp::board::make_board_table(fog::test::paper_like_model(), {200, kOutput});
  ASSERT_EQ(fog::read_model(table.span(), Image::capacity, parameters), fog::ModelError::none);
  Image image(parameters, fog::IntegrityToken::not_needed());
  fogcomp::board::HostCompensator full(parameters, fog::IntegrityToken::not_needed());
  std::uint8_t from_image[fog::kMaxOutputBytes];
  std::uint8_t from_full[fog::kMaxOutputBytes];
  const auto frame = fog::encode_sensor_frame({1, 700, 20 * kDegree, true, true});
  for (const std::uint8_t byte : frame) {
    const std::size_t size = image.feed(byte, from_image);
    ASSERT_EQ(full.feed(byte, from_full), size);
    EXPECT_TRUE(std::equal(from_image, from_image + size, from_full));
  }
}

TEST(CompensatorOfAnImage, HasRoomForItsOwnFramesAlone) {
  using Output = fog::OutputSelection;
  expect_room_for_its_own_frames_alone<Output::kvh>(Output::compact);
  expect_room_for_its_own_frames_alone<Output::compact>(Output::kvh);
}

TEST(CompensatorOfAnImage, NeedsNeitherNetworkNorDenoiser) {
  fogcomp::model::Model model = fog::test::paper_like_model();
  model.network = {};
  model.denoise.levels = 0;
  expect_same_bytes<fog::Compensator<kThreeEffects, 0, 0, 0, 0>>(model);
}

}  // namespace
