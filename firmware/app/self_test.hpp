#pragma once

#include <cstdint>

#include "app/model_table.hpp"
#include "core/health/integrity_token.hpp"
#include "core/health/memory_scan.hpp"
#include "core/health/sealed_scan.hpp"

namespace fog::app {

/// The last word of the image, as a little-endian number: no other image has the same.
std::uint32_t seal_of_image();

/// The built-in test of image, constants and memory: all of it at the start, then again and again,
/// a bounded piece a sample. What it finds while running it answers with a restart, after which the
/// test at the start says whether it was for once or for good.
class SelfTest {
 public:
  /// `sample_period_us` sets the size of a piece: a pass over image and constants takes 2.5 s of
  /// samples. `constants` are what in RAM must not change, with their seal; a `table` that is not
  /// part of the image is gone over as well. What the checks come to goes to `proof`.
  SelfTest(Span<const std::uint8_t> constants, const ModelTable& table,
           std::uint32_t sample_period_us, IntegrityToken& token);

  /// As long as a proof must last for the next one to be there.
  static IntegrityToken new_token(std::uint32_t sample_period_us);

  /// Everything once. Where image or memory is damaged, no sample will have a proof.
  void run_all();

  /// The next piece, after a sample was answered.
  void step();

  bool memory_good() const { return memory_good_; }
  std::uint32_t start_crc() const { return start_crc_; }  ///< of image and constants
  std::uint32_t image_passes() const { return image_passes_; }
  std::uint32_t memory_passes() const {
    return memory_blocks_ / static_cast<std::uint32_t>(memory_.blocks());
  }

 private:
  bool memory_step();

  SealedScan<ModelTable::sealed_parts> sealed_;
  MemoryScan<> memory_;
  IntegrityToken& token_;
  std::size_t bytes_a_step_;
  bool memory_good_ = false;
  std::uint32_t start_crc_ = kImageCrcStart;
  std::uint32_t image_passes_ = 0;
  std::uint32_t memory_blocks_ = 0;
};

}  // namespace fog::app
