#pragma once

#include <cstdint>
#include <random>

#include "board/board_table.hpp"
#include "core/frames/sensor_frame.hpp"
#include "support/sample_models.hpp"

namespace fog::test {

/// A stream that exercises every stage: a warming gyro with noise, lost samples, invalid samples, a
/// missing temperature and a rotation.
constexpr std::uint32_t kStreamSamples = 20000;  // 100 s

inline fogcomp::board::BoardTable stream_table() {
  return fogcomp::board::make_board_table(paper_like_model(), {200, fog::OutputSelection::both});
}

inline bool is_lost(std::uint32_t i) {
  return i % 3777 == 3776;
}

/// In order of i, of those that are lost as well.
inline fog::SensorSample stream_sample(std::uint32_t i, std::mt19937& random) {
  fog::SensorSample sample;
  sample.sequence = static_cast<std::uint16_t>(i);
  sample.rate_counts = static_cast<std::int32_t>(random() % 4001U) - 2000;
  if (i / 3000 == 2) sample.rate_counts += 36000000;  // 10 deg/s
  sample.temperature_q16 = static_cast<std::int32_t>(55 * 65536 + i * 40 + random() % 2000U);
  sample.gyro_valid = i % 4999 != 4998;
  sample.temperature_valid = i / 1500 != 7;
  return sample;
}

}  // namespace fog::test
