#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <string>

#include "core/frames/compact_frame.hpp"
#include "core/frames/kvh_frame.hpp"
#include "core/frames/rate_float.hpp"
#include "core/health/image_seal.hpp"

namespace {

using fog::Rate;

std::string hex(const std::uint8_t* bytes, std::size_t size) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < size; ++i) {
    text += kDigits[bytes[i] >> 4U];
    text += kDigits[bytes[i] & 0xFU];
  }
  return text;
}

float as_float(std::uint32_t bits) {
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

TEST(RateFloat, UsesPiOver648000) {
  const long double pi = 3.14159265358979323846264338327950288L;
  EXPECT_EQ(std::llround(std::ldexp(pi / 648000, 49)), 2729258392);
}

TEST(RateFloat, IsTheNearestFloatOrItsNeighbour) {
  std::mt19937 random(1);
  const auto check = [](std::int32_t raw) {
    const double exact = raw / 1024.0 * 3.14159265358979323846 / 648000;
    const float got = as_float(fog::rate_as_radians_float(Rate::from_raw(raw)));
    const auto nearest = static_cast<float>(exact);
    const float ulp = std::nextafter(std::abs(nearest), HUGE_VALF) - std::abs(nearest);
    ASSERT_LE(std::abs(got - nearest), ulp) << raw;
    ASSERT_LE(std::abs(static_cast<double>(got) - exact), 0.5001 * static_cast<double>(ulp)) << raw;
  };
  for (std::int32_t raw = -70000; raw < 70000; ++raw) check(raw);
  for (int i = 0; i < 1000000; ++i) check(static_cast<std::int32_t>(random()));
  for (const std::int32_t raw : {INT32_MIN, INT32_MAX}) check(raw);
}

fog::OutputSample sample() {
  fog::OutputSample sample;
  sample.sequence = 0xBEEF;
  sample.compensated = Rate::from_raw(-1024);
  sample.denoised = Rate::from_raw(15 * 3600 * 1024);  // 15 deg/s
  sample.drift = Rate::from_raw(700);
  sample.temperature = fog::Temperature::from_raw(-(40 << 16) + 0x8000);  // -39.5 degC
  return sample;
}

// Written by hand from the published format: header, six floats, status, sequence, degC,
// CRC-32/MPEG-2. 15 deg/s = 0.2617994 rad/s = 3e860a92.
TEST(KvhFrame, HasFormatAByteForByte) {
  const fog::KvhFrame frame =
      fog::encode_kvh_frame(sample().temperature, fog::rate_as_radians_float(sample().denoised),
                            true, 0x1FF, fog::kIntactImage);
  const std::string text = hex(frame.data(), 32);
  EXPECT_EQ(text,
            "fe81ff55"
            "0000000000000000"
            "3e860a92"
            "000000000000000000000000"
            "04"
            "7f"
            "ffd9");                // -39: halves round upwards
  std::uint32_t crc = 0xFFFFFFFFU;  // bit by bit, from the definition
  for (std::size_t i = 0; i < 32; ++i) {
    crc ^= static_cast<std::uint32_t>(frame[i]) << 24U;
    for (int bit = 0; bit < 8; ++bit)
      crc = (crc & 0x80000000U) != 0U ? (crc << 1U) ^ 0x04C11DB7U : crc << 1U;
  }
  const std::uint32_t sent = (static_cast<std::uint32_t>(frame[32]) << 24U) |
                             (static_cast<std::uint32_t>(frame[33]) << 16U) |
                             (static_cast<std::uint32_t>(frame[34]) << 8U) | frame[35];
  EXPECT_EQ(sent, crc);
}

TEST(KvhFrame, IsNotValidWhereTheDenoisedRateIsRefused) {
  for (unsigned bit = 0; bit < 32; ++bit) {
    fog::OutputSample faulty = sample();
    faulty.status = static_cast<fog::Status>(1U << bit);
    const bool refused = has_any(faulty.status, fog::kDenoisedInvalid);
    EXPECT_EQ(fog::encode_kvh_frame(faulty.temperature, fog::rate_as_radians_float(faulty.denoised),
                                    faulty.denoised_valid(), 0, fog::kIntactImage)[28],
              refused ? 0 : 4)
        << bit;
  }
}

TEST(CompactFrame, ReturnsWhatWasPutInAndRefusesDamage) {
  fog::OutputSample sent = sample();
  sent.status = fog::Status::drift_held | fog::Status::denoised_invalid;
  fog::CompactFrame frame = fog::encode_compact_frame(sent, 465, fog::kIntactImage);
  EXPECT_EQ(hex(frame.data(), 8), "c33cefbe00fcffff");
  fog::OutputSample got;
  std::uint16_t delay = 0;
  ASSERT_TRUE(fog::decode_compact_frame(frame.data(), got, delay));
  EXPECT_EQ(delay, 465);
  EXPECT_EQ(got.sequence, sent.sequence);
  EXPECT_EQ(got.compensated, sent.compensated);
  EXPECT_EQ(got.denoised, sent.denoised);
  EXPECT_EQ(got.drift, sent.drift);
  EXPECT_EQ(got.temperature, sent.temperature);
  EXPECT_EQ(got.status, sent.status);
  for (std::size_t bit = 0; bit < 8 * frame.size(); ++bit) {
    fog::CompactFrame damaged = frame;
    damaged[bit / 8] = static_cast<std::uint8_t>(damaged[bit / 8] ^ (1U << (bit % 8)));
    EXPECT_FALSE(fog::decode_compact_frame(damaged.data(), got, delay)) << bit;
  }
}

}  // namespace
