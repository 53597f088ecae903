// Prints the output of the whole pipeline for the stream of board_stream.hpp.

#include <cstdio>
#include <random>
#include <string>

#include "board/replay.hpp"
#include "core/bytes/crc.hpp"
#include "golden/board_stream.hpp"
#include "support/text.hpp"

namespace {

constexpr std::uint32_t kPerLine = 1000;

std::string describe_output() {
  const fogcomp::board::BoardTable table = fog::test::stream_table();
  const fog::ModelParameters parameters = fogcomp::board::read_board_table(table, "golden");
  fogcomp::board::Replay replay(parameters);
  std::mt19937 random(1);
  std::string text = "# CRC-32 and last 64 bytes of the output for every 1000 sensor samples\n";
  std::uint32_t crc = fog::kCrc32Initial;
  std::string tail;
  for (std::uint32_t i = 0; i < fog::test::kStreamSamples; ++i) {
    const fog::SensorFrame frame = fog::encode_sensor_frame(fog::test::stream_sample(i, random));
    const bool lost = fog::test::is_lost(i);
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
