#include "output_reader.hpp"

#include <algorithm>

#include "core/bytes/crc.hpp"
#include "core/frames/compact_frame.hpp"
#include "core/frames/kvh_frame.hpp"

namespace fogcomp::injection {
namespace {

constexpr std::uint8_t kKvhHeader[] = {0xFE, 0x81, 0xFF, 0x55};
constexpr std::size_t kKvhStatus = 28;
constexpr std::uint8_t kKvhValidBits = 7;

// The CRC over a frame and its own CRC is 0.
bool is_kvh_frame(const std::uint8_t* bytes) {
  return std::equal(std::begin(kKvhHeader), std::end(kKvhHeader), bytes) &&
         fog::crc32(bytes, fog::kKvhFrameBytes) == 0;
}

}  // namespace

void OutputReader::read(const Bytes& output) {
  while (output.size() - position_ >= fog::kKvhFrameBytes) {
    const std::uint8_t* bytes = output.data() + position_;
    fog::OutputSample sample;
    std::uint16_t delay = 0;
    bool valid = false;
    std::size_t size = 0;
    if (is_kvh_frame(bytes)) {
      size = fog::kKvhFrameBytes;
      valid = (bytes[kKvhStatus] & kKvhValidBits) != 0;
    } else if (fog::decode_compact_frame(bytes, sample, delay)) {
      size = fog::kCompactFrameBytes;
      valid = sample.compensated_valid() || sample.denoised_valid();
    }
    if (!valid && !saw_fault_ && (size == 0 || accepted_ >= kStarting)) {
      saw_fault_ = true;
      valid_before_fault_ = valid_;
    }
    accepted_ += size > 0;
    valid_ += valid;
    position_ += std::max(size, std::size_t{1});
  }
}

}  // namespace fogcomp::injection
