// make_sensor_stream FRAMES SEED OUT.bin: a sensor stream for the boards to replay, the same bytes
// for the same seed. A twentieth of it, two fifths in, is damaged in every way a line can damage
// it.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <vector>

#include "core/acquisition/sensor_frame.hpp"

namespace {

using Bytes = std::vector<std::uint8_t>;

// A slow drift under noise, while the coil warms by 1 degC a minute at 200 samples a second.
fog::SensorSample sample_at(std::uint32_t index, std::mt19937& random) {
  const auto noise = static_cast<std::int32_t>(random() % 4001U) - 2000;
  const auto step = static_cast<std::int32_t>(index);
  return {static_cast<std::uint16_t>(index), 12000 + step / 50 + noise,
          20 * 65536 + static_cast<std::int32_t>(std::int64_t{step} * 65536 / 12000), true, true};
}

void damage(Bytes& frame, std::mt19937& random) {
  const std::size_t at = random() % frame.size();
  const auto place = frame.begin() + static_cast<std::ptrdiff_t>(at);
  switch (random() % 4U) {
    case 0:
      frame[at] = static_cast<std::uint8_t>(frame[at] ^ (1U << (random() % 8U)));
      break;
    case 1:
      frame.erase(place);
      break;
    case 2:
      frame.insert(place, static_cast<std::uint8_t>(random()));
      break;
    default:
      for (std::uint8_t& byte : frame) byte = static_cast<std::uint8_t>(random());
      break;
  }
}

Bytes make_stream(std::uint32_t frames, std::uint32_t seed) {
  std::mt19937 random(seed);
  const std::uint32_t damaged_from = frames / 5U * 2U;
  const std::uint32_t damaged_to = damaged_from + frames / 20U;
  Bytes stream;
  for (std::uint32_t i = 0; i < frames; ++i) {
    const fog::SensorFrame good = fog::encode_sensor_frame(sample_at(i, random));
    Bytes frame(good.begin(), good.end());
    if (i >= damaged_from && i < damaged_to) damage(frame, random);
    stream.insert(stream.end(), frame.begin(), frame.end());
  }
  return stream;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: make_sensor_stream FRAMES SEED OUT.bin\n";
    return 2;
  }
  const Bytes stream = make_stream(static_cast<std::uint32_t>(std::strtoul(argv[1], nullptr, 10)),
                                   static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10)));
  std::ofstream file(argv[3], std::ios::binary);
  std::copy(stream.begin(), stream.end(), std::ostreambuf_iterator<char>(file));
  return file.flush() ? 0 : 1;
}
