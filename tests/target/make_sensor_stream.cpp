// make_sensor_stream FRAMES SEED OUT.bin [broken]: a sensor stream for the boards to replay, the
// same bytes for the same seed. A twentieth of it, two fifths in, is damaged in every way a line
// can damage it. With `broken`, the sensors fail in every way, too, one after the other, and
// samples are lost, repeated and late.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <vector>

#include "core/frames/sensor_frame.hpp"

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

// A fault lasts 512 samples, and as many go by between two.
void break_sensor(fog::SensorSample& sample, std::uint32_t index, std::mt19937& random) {
  if (index / 512U % 2U == 0U) return;
  switch (index / 1024U % 12U) {
    case 0:
      sample.rate_counts = 4711;
      break;
    case 1:
      sample.rate_counts = 4711 + static_cast<std::int32_t>(index % 2U);
      break;
    case 2:  // up to the end of the range and beyond
      sample.rate_counts =
          static_cast<std::int32_t>(std::int64_t{INT32_MAX} * (index % 512U) / 512);
      break;
    case 3:
      if (random() % 16U == 0U) sample.rate_counts = static_cast<std::int32_t>(random());
      break;
    case 4:
      sample.rate_counts = index % 2U == 0U ? INT32_MIN : INT32_MAX;
      break;
    case 5:
      sample.gyro_valid = random() % 2U == 0U;
      break;
    case 6:
      sample.temperature_valid = false;
      break;
    case 7:
      sample.temperature_q16 = 85 * 65536;
      break;
    case 8:
      sample.temperature_q16 = static_cast<std::int32_t>(random());
      break;
    case 9:
      sample.temperature_q16 = 20 * 65536;
      break;
    case 10:
      sample.sequence = static_cast<std::uint16_t>(sample.sequence + random() % 4U);
      break;
    default:
      sample.sequence = static_cast<std::uint16_t>(random());
      break;
  }
}

Bytes make_stream(std::uint32_t frames, std::uint32_t seed, bool broken) {
  std::mt19937 random(seed);
  const std::uint32_t damaged_from = frames / 5U * 2U;
  const std::uint32_t damaged_to = damaged_from + frames / 20U;
  Bytes stream;
  for (std::uint32_t i = 0; i < frames; ++i) {
    fog::SensorSample sample = sample_at(i, random);
    if (broken) break_sensor(sample, i, random);
    const fog::SensorFrame good = fog::encode_sensor_frame(sample);
    Bytes frame(good.begin(), good.end());
    if (i >= damaged_from && i < damaged_to) damage(frame, random);
    stream.insert(stream.end(), frame.begin(), frame.end());
  }
  return stream;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4 && argc != 5) {
    std::cerr << "usage: make_sensor_stream FRAMES SEED OUT.bin [broken]\n";
    return 2;
  }
  const Bytes stream =
      make_stream(static_cast<std::uint32_t>(std::strtoul(argv[1], nullptr, 10)),
                  static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10)), argc == 5);
  std::ofstream file(argv[3], std::ios::binary);
  std::copy(stream.begin(), stream.end(), std::ostreambuf_iterator<char>(file));
  return file.flush() ? 0 : 1;
}
