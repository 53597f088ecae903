#pragma once

#include <cstdint>

#include "core/health/image_seal.hpp"

namespace fog {

/// The CRC that the last check of the image came to, with an end to its worth. It is used up sample
/// by sample; after so many, the one that was given meanwhile takes its place, and with none there
/// is no proof. So a check that has stopped, or whose result never arrives, is found by code that
/// the check has no part in. It is kept twice, for two uses that must not share a load or an
/// operation: one flipped bit in the code can make a bad CRC look good once, not twice.
class ImageProof {
 public:
  /// A given CRC lasts `samples` (>= 1).
  explicit ImageProof(std::uint32_t samples) : samples_(samples) {}

  /// For a computer that has no image to check: always kIntactImage.
  static ImageProof not_needed() {
    ImageProof proof(kForEver);
    proof.give(kIntactImage, kIntactImage);
    return proof;
  }

  /// What a check came to, good or bad, read twice.
  void give(std::uint32_t for_status, std::uint32_t for_frames) {
    next_status_ = for_status;
    next_frames_ = for_frames;
  }

  /// Before the next sample.
  void take() {
    if (left_ == 0) {
      status_ = next_status_;
      frames_ = next_frames_;
      next_status_ = next_frames_ = kImageCrcStart;
      left_ = samples_;
    }
    if (samples_ != kForEver) --left_;
  }

  /// kIntactImage only if a check came to that, and lately.
  std::uint32_t for_status() const { return status_; }
  std::uint32_t for_frames() const { return frames_; }

 private:
  static constexpr std::uint32_t kForEver = 0xFFFFFFFFU;

  std::uint32_t samples_;
  std::uint32_t left_ = 0;
  std::uint32_t status_ = kImageCrcStart;
  std::uint32_t frames_ = kImageCrcStart;
  std::uint32_t next_status_ = kImageCrcStart;
  std::uint32_t next_frames_ = kImageCrcStart;
};

}  // namespace fog
