#pragma once

#include <cstdint>

#include "core/health/image_seal.hpp"

namespace fog {

/// The CRC that the last check of the image came to, with an end to its worth. It is handed out
/// sample by sample; after so many, the one that was given meanwhile takes its place, and with none
/// there is no proof. So a check that has stopped, or whose result never arrives, is found by code
/// that the check has no part in.
class ImageProof {
 public:
  /// A given CRC lasts `samples` (>= 1).
  explicit ImageProof(std::uint32_t samples) : samples_(samples) {}

  /// For a computer that has no image to check: always kIntactImage.
  static ImageProof not_needed() {
    ImageProof proof(kForEver);
    proof.give(kIntactImage);
    return proof;
  }

  /// What a check came to, good or bad.
  void give(std::uint32_t image_crc) { next_ = image_crc; }

  /// For the next sample: kIntactImage only if a check came to that, and lately.
  std::uint32_t take() {
    if (left_ == 0) {
      current_ = next_;
      next_ = kImageCrcStart;
      left_ = samples_;
    }
    if (samples_ != kForEver) --left_;
    return current_;
  }

 private:
  static constexpr std::uint32_t kForEver = 0xFFFFFFFFU;

  std::uint32_t samples_;
  std::uint32_t left_ = 0;
  std::uint32_t current_ = kImageCrcStart;
  std::uint32_t next_ = kImageCrcStart;
};

}  // namespace fog
