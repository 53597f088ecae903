#include "core/acquisition/stream_parser.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "core/protocol/crc.hpp"

namespace {

using fog::encode_sensor_frame;
using fog::SensorFrame;
using fog::SensorSample;
using fog::StreamParser;

SensorSample sample_of(std::uint16_t sequence) {
  return {sequence, -123456789 + sequence, 25 << 16, true, true};
}

std::vector<std::uint16_t> accepted(StreamParser& parser, const std::vector<std::uint8_t>& bytes) {
  std::vector<std::uint16_t> sequences;
  for (const std::uint8_t byte : bytes) {
    if (parser.feed(byte)) sequences.push_back(parser.sample().sequence);
  }
  return sequences;
}

void append(std::vector<std::uint8_t>& bytes, const SensorFrame& frame) {
  bytes.insert(bytes.end(), frame.begin(), frame.end());
}

TEST(Crc, KeepsTheCheckValuesOfItsDefinitions) {
  const std::uint8_t digits[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(fog::crc16(digits, sizeof digits), 0x29B1);
  EXPECT_EQ(fog::crc32(digits, sizeof digits), 0x0376E6E7U);
}

TEST(StreamParser, ReturnsWhatWasSent) {
  StreamParser parser;
  const SensorSample sent{0xFEDC, -2147483647 - 1, -40 * 65536, true, false};
  for (const std::uint8_t byte : encode_sensor_frame(sent)) parser.feed(byte);
  EXPECT_EQ(parser.sample().sequence, sent.sequence);
  EXPECT_EQ(parser.sample().rate_counts, sent.rate_counts);
  EXPECT_EQ(parser.sample().temperature_q16, sent.temperature_q16);
  EXPECT_TRUE(parser.sample().gyro_valid);
  EXPECT_FALSE(parser.sample().temperature_valid);
}

TEST(StreamParser, IsBackWithinOneGoodFrameWhereverBytesAreLost) {
  for (std::size_t lost = 1; lost <= fog::kSensorFrameBytes; ++lost) {
    for (std::size_t at = 0; at < fog::kSensorFrameBytes; ++at) {
      std::vector<std::uint8_t> bytes;
      for (std::uint16_t i = 0; i < 5; ++i) append(bytes, encode_sensor_frame(sample_of(i)));
      const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(fog::kSensorFrameBytes + at);
      bytes.erase(first, first + static_cast<std::ptrdiff_t>(lost));
      StreamParser parser;
      const auto sequences = accepted(parser, bytes);
      ASSERT_GE(sequences.size(), 3U) << lost << " lost at " << at;
      EXPECT_EQ(sequences[sequences.size() - 2], 3);
      EXPECT_EQ(sequences.back(), 4);
    }
  }
}

TEST(StreamParser, RefusesEveryFrameWithOneOrTwoFlippedBits) {
  const SensorFrame good = encode_sensor_frame(sample_of(7));
  constexpr std::size_t kBits = fog::kSensorFrameBytes * 8;
  for (std::size_t first = 0; first < kBits; ++first) {
    for (std::size_t second = first; second < kBits; ++second) {
      SensorFrame damaged = good;
      damaged[first / 8] = static_cast<std::uint8_t>(damaged[first / 8] ^ (1U << (first % 8)));
      if (second != first) {
        damaged[second / 8] = static_cast<std::uint8_t>(damaged[second / 8] ^ (1U << (second % 8)));
      }
      SensorSample sample;
      ASSERT_FALSE(fog::decode_sensor_frame(damaged.data(), sample)) << first << ", " << second;
    }
  }
}

TEST(StreamParser, FindsEveryFrameBetweenRandomBytes) {
  std::mt19937 random(1);
  StreamParser parser;
  std::uint16_t found = 0;
  for (std::uint16_t i = 0; i < 2000; ++i) {
    std::vector<std::uint8_t> bytes;
    for (std::size_t n = random() % 40; n > 0; --n) {
      bytes.push_back(random() % 3 == 0 ? fog::kSensorSync0 : static_cast<std::uint8_t>(random()));
    }
    append(bytes, encode_sensor_frame(sample_of(i)));
    append(bytes, encode_sensor_frame(sample_of(i)));
    for (const std::uint16_t sequence : accepted(parser, bytes)) {
      EXPECT_EQ(sequence, i);
      ++found;
    }
  }
  EXPECT_GE(found, 2000);
}

}  // namespace
