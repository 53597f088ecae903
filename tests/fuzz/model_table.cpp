// Model tables with a right CRC and arbitrary numbers: the firmware refuses them, or runs them on
// any samples without fixed-point overflow. The first two bytes are the number of words.
#include <array>
#include <vector>

#include "board/host_compensator.hpp"
#include "core/bytes/byte_order.hpp"
#include "fuzzing.hpp"
#include "support/overflow_guard.hpp"

using fog::test::promise;

namespace {

constexpr std::ptrdiff_t kSampleSize = 9;

fog::SensorSample sample_from(const std::uint8_t* bytes, std::uint16_t sequence) {
  const std::uint8_t flags = bytes[8];
  fog::SensorSample sample;
  sample.sequence = static_cast<std::uint16_t>(sequence + (flags >> 2));
  sample.rate_counts = static_cast<std::int32_t>(fog::load_le32(bytes));
  sample.temperature_q16 = static_cast<std::int32_t>(fog::load_le32(bytes + 4));
  sample.gyro_valid = (flags & 1U) == 0;
  sample.temperature_valid = (flags & 2U) == 0;
  return sample;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const std::size_t count = fog::load_le16(data);
  if (count < 5 || count > fog::kMaxModelWords || size < 2 + 4 * count) return 0;
  std::vector<std::int32_t> words(count);
  for (std::size_t i = 0; i < count; ++i) {
    words[i] = static_cast<std::int32_t>(fog::load_le32(data + 2 + 4 * i));
  }
  words[0] = fog::kModelMagic;
  words[1] = fog::kModelLayout;
  words[2] = static_cast<std::int32_t>(count);
  words.back() = static_cast<std::int32_t>(fog::model_table_crc({words.data(), count}));
  fog::ModelParameters parameters;
  if (fog::read_model({words.data(), count}, fog::kAnyModel, parameters) != fog::ModelError::none) {
    return 0;
  }
  fogcomp::board::HostCompensator board(parameters, fog::IntegrityToken::not_needed());
  const std::uint8_t* const end = data + size;
  std::uint16_t sequence = 0;
  for (const std::uint8_t* at = data + 2 + 4 * count; end - at >= kSampleSize; at += kSampleSize) {
    // Each sample for a while, so that slow parts run too.
    for (int repeat = 0; repeat < 20; ++repeat) {
      const fog::SensorSample sample = sample_from(at, sequence);
      sequence = static_cast<std::uint16_t>(sample.sequence + 1);
      board.process(sample);
    }
  }
  std::array<std::uint32_t, fogcomp::board::HostCompensator::kMaxStateWords> state{};
  const std::size_t kept = board.keep(state.data());
  promise(kept <= state.size(), "what outlives a restart has room");
  if (kept > 0) board.resume(state.data(), true);
  promise(fog::test::overflows() == 0, "no operation leaves its range");
  return 0;
}
