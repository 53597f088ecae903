#pragma once

#include <cstdint>

#include "core/health/image_seal.hpp"

namespace fog {

/// Result of the latest check of the image, with a limited life counted in samples. When it
/// expires, the result published in the meantime replaces it; without one the token is bad. So code
/// outside the check notices a check that has stopped or whose result never arrives. The result is
/// stored twice, for two uses that must not share a load or an operation: one flipped bit in the
/// code can make a bad CRC look good in one use, not in both.
class IntegrityToken {
 public:
  /// A published CRC is valid for `samples` (>= 1) samples.
  explicit IntegrityToken(std::uint32_t samples) : samples_(samples) {}

  /// Token of a computer that has no image to check: always kIntactImage.
  static IntegrityToken not_needed() {
    IntegrityToken token(kForEver);
    token.publish(kIntactImage, kIntactImage);
    return token;
  }

  /// Publishes the CRC that a check has computed, good or bad; the caller reads it twice.
  void publish(std::uint32_t for_status, std::uint32_t for_frames) {
    next_status_ = for_status;
    next_frames_ = for_frames;
  }

  /// To be called before each sample.
  void consume() {
    if (left_ == 0) {
      status_ = next_status_;
      frames_ = next_frames_;
      next_status_ = next_frames_ = kImageCrcStart;
      left_ = samples_;
    }
    if (samples_ != kForEver) --left_;
  }

  /// kIntactImage only if the CRC of a recent check equals it.
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
