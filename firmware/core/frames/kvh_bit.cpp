#include "core/frames/kvh_bit.hpp"

namespace fog {
namespace {

// Numbers of KVH's tests: 8 * byte + bit. Of the Z axis, the processor board and its link to the
// sensors. A test that this gyro has not is passed.
constexpr struct {
  Status flags;
  std::uint8_t test;
} kTests[] = {
    {Status::gyro_invalid | Status::gyro_stuck | Status::rate_out_of_range | Status::rate_jump, 11},
    {Status::model_refused, 12},
    {Status::temperature_invalid, 21},
    {Status::self_test_failed, 42},
    {Status::sequence_gap | Status::sample_rate | Status::no_samples, 44},
};

constexpr std::size_t kHeaderBytes = 4;
constexpr std::uint8_t kAllPassed = 0x7F;

}  // namespace

std::size_t encode_kvh_bit(Status status, bool extended, std::uint8_t* out) {
  const std::size_t size = extended ? kKvhExtendedBitBytes : kKvhBitBytes;
  const std::uint8_t header[kHeaderBytes] = {0xFE, 0x81, 0x00,
                                             static_cast<std::uint8_t>(extended ? 0xAB : 0xAA)};
  for (std::size_t i = 0; i + 1 < size; ++i) out[i] = i < kHeaderBytes ? header[i] : kAllPassed;
  for (const auto& each : kTests) {
    std::uint8_t& tests = out[kHeaderBytes + each.test / 8U];
    if (has_any(status, each.flags))
      tests = static_cast<std::uint8_t>(tests ^ 1U << each.test % 8U);
  }
  std::uint8_t sum = 0;
  for (std::size_t i = 0; i + 1 < size; ++i) sum = static_cast<std::uint8_t>(sum + out[i]);
  out[size - 1] = sum;
  return size;
}

}  // namespace fog
