#include "core/frames/stream_parser.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <random>
#include <vector>

#include "core/bytes/crc.hpp"

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
    if (parser.feed(byte) == StreamParser::Found::sample)
      sequences.push_back(parser.sample().sequence);
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

// A later format may give these bits a meaning, so it is no frame, whatever its CRC.
TEST(StreamParser, RefusesReservedBytesUnknownBitsAndUnknownInputsWithAGoodCrc) {
  const auto sample_is_taken = [](std::size_t at, std::uint8_t value) {
    SensorFrame frame = encode_sensor_frame(sample_of(1));
    frame[at] = value;
    const std::uint16_t crc = fog::crc16(&frame[2], 12);
    frame[14] = static_cast<std::uint8_t>(crc);
    frame[15] = static_cast<std::uint8_t>(crc >> 8U);
    SensorSample got;
    return fog::decode_sensor_frame(frame.data(), got);
  };
  for (unsigned status = 0; status < 256; ++status) {
    EXPECT_EQ(sample_is_taken(12, static_cast<std::uint8_t>(status)), status < 4) << status;
  }
  EXPECT_TRUE(sample_is_taken(13, 0));
  for (const std::uint8_t reserved : std::initializer_list<std::uint8_t>{1, 2, 128})
    EXPECT_FALSE(sample_is_taken(13, reserved));
  EXPECT_FALSE(sample_is_taken(0, 0xA4));
  EXPECT_FALSE(sample_is_taken(1, 0x5B));

  const auto record_is_taken = [](std::size_t at, std::uint8_t value) {
    fog::ExtensionFrame frame = fog::encode_extension_frame({});
    frame[at] = value;
    const std::uint16_t crc = fog::crc16(&frame[1], 7);
    frame[8] = static_cast<std::uint8_t>(crc);
    frame[9] = static_cast<std::uint8_t>(crc >> 8U);
    fog::ExtensionRecord got;
    return fog::decode_extension_frame(frame.data(), got);
  };
  for (std::uint8_t input = 0; input < 8; ++input) {
    EXPECT_EQ(record_is_taken(2, input), input < 5) << unsigned{input};
  }
  for (const std::uint8_t reserved : std::initializer_list<std::uint8_t>{1, 2, 128})
    EXPECT_FALSE(record_is_taken(3, reserved));
  EXPECT_FALSE(record_is_taken(0, 0xA4));
  EXPECT_FALSE(record_is_taken(1, 0xC2));
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

// ---- extension records ----

using fog::encode_extension_frame;
using fog::ExtensionFrame;
using fog::ExtensionRecord;
using Found = StreamParser::Found;

ExtensionRecord record_of(std::uint16_t i) {
  return {fog::extension_input(i % fog::kExtensionInputs),
          fog::ExtensionValue::from_raw(-123456789 + i)};
}

void append(std::vector<std::uint8_t>& bytes, const ExtensionFrame& frame) {
  bytes.insert(bytes.end(), frame.begin(), frame.end());
}

// Result of parsing a stream: values of records, then sequences of samples.
struct Accepted {
  std::vector<std::int32_t> records;
  std::vector<std::uint16_t> samples;
};

Accepted all_accepted(const std::vector<std::uint8_t>& bytes) {
  StreamParser parser;
  Accepted accepted;
  for (const std::uint8_t byte : bytes) {
    const Found found = parser.feed(byte);
    if (found == Found::extension) accepted.records.push_back(parser.extension().value.raw());
    if (found == Found::sample) accepted.samples.push_back(parser.sample().sequence);
  }
  return accepted;
}

TEST(ExtensionRecord, IsReturnedAsSentForEveryInput) {
  for (std::uint16_t i = 0; i < fog::kExtensionInputs; ++i) {
    StreamParser parser;
    Found found = Found::nothing;
    for (const std::uint8_t byte : encode_extension_frame(record_of(i))) {
      ASSERT_EQ(found, Found::nothing);
      found = parser.feed(byte);
    }
    ASSERT_EQ(found, Found::extension);
    EXPECT_EQ(parser.extension().input, record_of(i).input);
    EXPECT_EQ(parser.extension().value, record_of(i).value);
  }
}

TEST(ExtensionRecord, LeavesTheSamplesAroundItAlone) {
  std::vector<std::uint8_t> bytes;
  for (std::uint16_t i = 0; i < 100; ++i) {
    for (std::uint16_t n = 0; n < i % 7; ++n) append(bytes, encode_extension_frame(record_of(i)));
    append(bytes, encode_sensor_frame(sample_of(i)));
  }
  const Accepted accepted = all_accepted(bytes);
  EXPECT_EQ(accepted.samples.size(), 100U);
  EXPECT_EQ(accepted.records.size() * fog::kExtensionFrameBytes +
                accepted.samples.size() * fog::kSensorFrameBytes,
            bytes.size());
}

TEST(ExtensionRecord, IsRefusedWithOneOrTwoFlippedBits) {
  const ExtensionFrame good = encode_extension_frame(record_of(3));
  constexpr std::size_t kBits = fog::kExtensionFrameBytes * 8;
  for (std::size_t first = 0; first < kBits; ++first) {
    for (std::size_t second = first; second < kBits; ++second) {
      ExtensionFrame damaged = good;
      damaged[first / 8] = static_cast<std::uint8_t>(damaged[first / 8] ^ (1U << (first % 8)));
      if (second != first) {
        damaged[second / 8] = static_cast<std::uint8_t>(damaged[second / 8] ^ (1U << (second % 8)));
      }
      ExtensionRecord record;
      ASSERT_FALSE(fog::decode_extension_frame(damaged.data(), record)) << first << ", " << second;
    }
  }
}

TEST(ExtensionRecord, IsRefusedForAnInputThatDoesNotExist) {
  for (std::size_t input = fog::kExtensionInputs; input < 256; ++input) {
    const ExtensionFrame frame = encode_extension_frame({fog::extension_input(input), {}});
    ExtensionRecord record;
    EXPECT_FALSE(fog::decode_extension_frame(frame.data(), record)) << input;
  }
}

// Wherever bytes are lost, every complete frame is found: records within the bytes of a broken
// sample, and samples after broken records.
TEST(ExtensionRecord, AndSampleAreAllFoundWhereverBytesAreLost) {
  std::vector<std::uint8_t> good;
  for (std::uint16_t i = 0; i < 4; ++i) {
    append(good, encode_extension_frame(record_of(i)));
    append(good, encode_sensor_frame(sample_of(i)));
  }
  constexpr std::size_t kPair = fog::kExtensionFrameBytes + fog::kSensorFrameBytes;
  for (std::size_t lost = 1; lost <= kPair; ++lost) {
    for (std::size_t at = 0; at + lost <= 2 * kPair; ++at) {
      std::vector<std::uint8_t> bytes = good;
      const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(at);
      bytes.erase(first, first + static_cast<std::ptrdiff_t>(lost));
      const Accepted accepted = all_accepted(bytes);
      ASSERT_GE(accepted.samples.size(), 2U) << lost << " lost at " << at;
      ASSERT_GE(accepted.records.size(), 2U) << lost << " lost at " << at;
      EXPECT_EQ(accepted.samples[accepted.samples.size() - 2], 2);
      EXPECT_EQ(accepted.samples.back(), 3);
      EXPECT_EQ(accepted.records[accepted.records.size() - 2], record_of(2).value.raw());
      EXPECT_EQ(accepted.records.back(), record_of(3).value.raw());
    }
  }
}

TEST(ExtensionRecord, IsFoundBetweenRandomBytesAndNothingElseIs) {
  std::mt19937 random(2);
  std::vector<std::uint8_t> bytes;
  const auto append_noise = [&] {
    for (std::size_t n = random() % 20; n > 0; --n) {
      const std::uint8_t syncs[] = {fog::kSensorSync0, fog::kSensorSync1, fog::kExtensionSync1};
      bytes.push_back(random() % 2 == 0 ? syncs[random() % 3]
                                        : static_cast<std::uint8_t>(random()));
    }
  };
  for (std::uint16_t i = 0; i < 2000; ++i) {
    append_noise();
    append(bytes, encode_extension_frame(record_of(i)));
    append_noise();
    append(bytes, encode_sensor_frame(sample_of(i)));
  }
  for (int i = 0; i < 16; ++i) bytes.push_back(0);  // so that no candidate is left open
  const Accepted accepted = all_accepted(bytes);
  EXPECT_EQ(accepted.samples.size(), 2000U);
  EXPECT_EQ(accepted.records.size(), 2000U);
}

}  // namespace
