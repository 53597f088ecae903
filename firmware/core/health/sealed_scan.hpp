#pragma once

#include <cstddef>
#include <cstdint>

#include "core/bytes/crc.hpp"
#include "core/health/image_seal.hpp"
#include "core/signal/span.hpp"

namespace fog {

/// Goes over the image, then over constants in RAM, again and again, a few bytes at a time. Both
/// are sealed, so that the CRC is kIntactImage at the end of the one and of the other.
class SealedScan {
 public:
  SealedScan(Span<const std::uint8_t> image, Span<const std::uint8_t> constants)
      : image_(image), constants_(constants) {}

  std::size_t size() const { return image_.size + constants_.size; }

  /// Takes the next `bytes` (>= 1), fewer at the end. Returns whether that was the end; `crc` is
  /// then that of the whole pass, and the next call begins anew. No finished CRC is kept: it could
  /// be read again by a scan that has stopped.
  bool step(std::size_t bytes, volatile std::uint32_t& crc) {
    if (position_ == size()) position_ = 0;  // not beside crc_, or one spoilt store would keep both
    while (bytes > 0 && position_ < size()) bytes -= take(bytes);
    if (position_ != size()) return false;
    crc = crc_;
    crc_ = kImageCrcStart;
    return true;
  }

 private:
  // Returns how many bytes it took, none of them from the second part before the first is over.
  std::size_t take(std::size_t bytes) {
    const bool in_image = position_ < image_.size;
    const Span<const std::uint8_t>& part = in_image ? image_ : constants_;
    const std::size_t from = in_image ? position_ : position_ - image_.size;
    const std::size_t left = part.size - from;
    if (bytes > left) bytes = left;
    crc_ = crc32(part.data + from, bytes, crc_);
    position_ += bytes;
    return bytes;
  }

  Span<const std::uint8_t> image_;
  Span<const std::uint8_t> constants_;
  std::size_t position_ = 0;
  std::uint32_t crc_ = kImageCrcStart;
};

}  // namespace fog
