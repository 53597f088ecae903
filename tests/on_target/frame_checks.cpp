#include "core/bytes/crc.hpp"
#include "core/frames/compact_frame.hpp"
#include "core/frames/kvh_frame.hpp"
#include "core/frames/rate_float.hpp"
#include "core/frames/sensor_frame.hpp"
#include "core/frames/stream_parser.hpp"
#include "core/health/image_seal.hpp"
#include "on_target/checks.hpp"

namespace fog::checks {
namespace {

OutputSample output_sample() {
  OutputSample sample;
  sample.sequence = 0xBEEF;
  sample.compensated = Rate::from_raw(-1024);
  sample.denoised = Rate::from_raw(15 * 3600 * 1024);  // 15 deg/s
  sample.drift = Rate::from_raw(700);
  sample.temperature = Temperature::from_raw(-40 * 65536 + 0x8000);  // -39.5 degC
  return sample;
}

constexpr SensorSample kSample{0x1234, -7654321, -40 * 65536, true, false};

bool same(const SensorSample& a, const SensorSample& b) {
  return a.sequence == b.sequence && a.rate_counts == b.rate_counts &&
         a.temperature_q16 == b.temperature_q16 && a.gyro_valid == b.gyro_valid &&
         a.temperature_valid == b.temperature_valid;
}

template <class Bytes>
void flip(Bytes& bytes, std::size_t bit) {
  bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ (1U << (bit % 8)));
}

}  // namespace

bool crcs_have_their_published_values() {
  constexpr std::uint8_t kText[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  return crc16(kText, sizeof kText) == 0x29B1 && crc32(kText, sizeof kText) == 0x0376E6E7 &&
         crc8(kText, sizeof kText) == 0xA1;
}

bool sensor_frame_survives_and_damage_is_refused() {
  const SensorFrame frame = encode_sensor_frame(kSample);
  SensorSample got;
  if (!decode_sensor_frame(frame.data(), got) || !same(got, kSample)) return false;
  for (std::size_t bit = 0; bit < 8 * frame.size(); ++bit) {
    SensorFrame damaged = frame;
    flip(damaged, bit);
    if (decode_sensor_frame(damaged.data(), got)) return false;
  }
  return true;
}

bool parser_finds_the_frame_behind_garbage() {
  const SensorFrame frame = encode_sensor_frame(kSample);
  StreamParser parser;
  for (std::size_t cut = 0; cut < frame.size(); ++cut) {
    for (std::size_t i = cut; i < frame.size(); ++i) parser.feed(frame[i]);
    std::uint32_t found = 0;
    for (int frames = 0; frames < 2; ++frames) {
      for (const std::uint8_t byte : frame) {
        if (parser.feed(byte) == StreamParser::Found::sample && same(parser.sample(), kSample)) {
          ++found;
        }
      }
    }
    if (found == 0) return false;
  }
  return true;
}

// As published: header, six floats, status, sequence, degC. 15 deg/s = 0.2617994 rad/s = 3e860a92.
bool kvh_frame_is_byte_for_byte_format_a() {
  constexpr std::uint8_t kExpected[32] = {0xFE, 0x81, 0xFF, 0x55, 0,    0, 0,    0,    0,    0,   0,
                                          0,    0x3E, 0x86, 0x0A, 0x92, 0, 0,    0,    0,    0,   0,
                                          0,    0,    0,    0,    0,    0, 0x04, 0x7F, 0xFF, 0xD9};
  const KvhFrame frame =
      encode_kvh_frame(output_sample().temperature, rate_as_radians_float(output_sample().denoised),
                       true, 0x1FF, kIntactImage);
  for (std::size_t i = 0; i < sizeof kExpected; ++i) {
    if (frame[i] != kExpected[i]) return false;
  }
  const std::uint32_t crc = crc32(kExpected, sizeof kExpected);
  for (std::size_t i = 0; i < 4; ++i) {
    if (frame[32 + i] != (crc >> (24U - 8U * i)) % 256U) return false;
  }
  return true;
}

bool compact_frame_survives_and_damage_is_refused() {
  OutputSample sent = output_sample();
  sent.status = Status::drift_held | Status::denoised_invalid;
  const CompactFrame frame = encode_compact_frame(sent, 465, kIntactImage);
  OutputSample got;
  std::uint16_t delay = 0;
  if (!decode_compact_frame(frame.data(), got, delay)) return false;
  if (delay != 465 || got.sequence != sent.sequence || got.compensated != sent.compensated ||
      got.denoised != sent.denoised || got.drift != sent.drift ||
      got.temperature != sent.temperature || got.status != sent.status) {
    return false;
  }
  for (std::size_t bit = 0; bit < 8 * frame.size(); ++bit) {
    CompactFrame damaged = frame;
    flip(damaged, bit);
    if (decode_compact_frame(damaged.data(), got, delay)) return false;
  }
  return true;
}

}  // namespace fog::checks
