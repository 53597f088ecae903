#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/bytes/crc.hpp"
#include "core/health/image_seal.hpp"
#include "core/signal/span.hpp"

namespace fog {

/// Computes the CRC of the image, then of everything else that must not change (constants in RAM, a
/// model in flash), repeatedly, a few bytes at a time. All parts are sealed, so that the CRC is
/// kIntactImage at the end of each.
template <std::size_t kParts>
class SealedScan {
 public:
  using Parts = std::array<Span<const std::uint8_t>, kParts>;

  static_assert(kParts >= 2);

  explicit SealedScan(const Parts& parts) : parts_(parts) {}

  std::size_t size() const {
    std::size_t size = parts_[0].size;
    for (std::size_t i = 1; i < kParts; ++i) size += parts_[i].size;
    return size;
  }

  /// Takes the next `bytes` (>= 1), fewer at the end. Returns whether the pass is complete; `crc`
  /// is then its CRC, and the next call starts a new pass. No finished CRC is kept: a scan that has
  /// stopped could be read again.
  bool step(std::size_t bytes, volatile std::uint32_t& crc) {
    if (position_ == size())
      position_ = 0;  // apart from crc_, or one corrupted store would keep both
    while (bytes > 0 && position_ < size()) bytes -= take(bytes);
    if (position_ != size()) return false;
    crc = crc_;
    crc_ = kImageCrcStart;
    return true;
  }

 private:
  // Returns the number of bytes taken, all of one part.
  std::size_t take(std::size_t bytes) {
    const bool in_first = position_ < parts_[0].size;
    std::size_t from = in_first ? position_ : position_ - parts_[0].size;
    const Span<const std::uint8_t>* part = in_first ? &parts_[0] : &parts_[1];
    if constexpr (kParts > 2) {
      while (!in_first && from >= part->size) from -= part++->size;
    }
    const std::size_t left = part->size - from;
    if (bytes > left) bytes = left;
    crc_ = crc32(part->data + from, bytes, crc_);
    position_ += bytes;
    return bytes;
  }

  Parts parts_;
  std::size_t position_ = 0;
  std::uint32_t crc_ = kImageCrcStart;
};

}  // namespace fog
