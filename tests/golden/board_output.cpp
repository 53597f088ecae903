// Prints what the whole pipeline sends for a stream that gives every stage something to do: a
// warming gyro under noise, with lost samples, invalid samples, a temperature that goes missing and
// a rotation.

#include <cstdio>
#include <random>
#include <string>

#include "core/acquisition/sensor_frame.hpp"
#include "core/protocol/crc.hpp"
#include "replay/replay.hpp"
#include "support/sample_models.hpp"
#include "support/text.hpp"

namespace {

constexpr std::uint32_t kSamples = 20000;  // 100 s
constexpr std::uint32_t kPerLine = 1000;

fog::SensorSample sample_at(std::uint32_t i, std::mt19937& random) {
  fog::SensorSample sample;
  sample.sequence = static_cast<std::uint16_t>(i);
  sample.rate_counts = static_cast<std::int32_t>(random() % 4001U) - 2000;
  if (i / 3000 == 2) sample.rate_counts += 36000000;  // 10 deg/s
  sample.temperature_q16 = static_cast<std::int32_t>(55 * 65536 + i * 40 + random() % 2000U);
  sample.gyro_valid = i % 4999 != 4998;
  sample.temperature_valid = i / 1500 != 7;
  return sample;
}

std::string describe_output() {
  const fogcomp::BoardTable table =
      fogcomp::make_board_table(fog::test::paper_like_model(), {200, fog::OutputSelection::both});
  const fog::ModelParameters parameters = fogcomp::read_board_table(table, "golden");
  fogcomp::Replay replay(parameters);
  std::mt19937 random(1);
  std::string text = "# CRC-32 and last 64 bytes of the output for every 1000 sensor samples\n";
  std::uint32_t crc = fog::kCrc32Initial;
  std::string tail;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const fog::SensorFrame frame = fog::encode_sensor_frame(sample_at(i, random));
    const bool lost = i % 3777 == 3776;
    const auto bytes =
        lost ? fog::Span<const std::uint8_t>{} : replay.feed({frame.data(), frame.size()});
    if (!lost) {
      crc = fog::crc32(bytes.data, bytes.size, crc);
      tail.clear();
      for (const std::uint8_t byte : bytes) tail += fogcomp::format("%02x", unsigned{byte});
    }
    if (i % kPerLine == kPerLine - 1) {
      text += fogcomp::format("%u %08x ", i + 1, static_cast<unsigned>(crc)) + tail + "\n";
    }
  }
  return text;
}

}  // namespace

int main() {
  std::fputs(describe_output().c_str(), stdout);
  return 0;
}
