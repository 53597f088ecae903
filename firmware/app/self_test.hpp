#pragma once

#include <cstdint>

#include "app/model_table.hpp"
#include "core/health/integrity_token.hpp"
#include "core/health/memory_scan.hpp"
#include "core/health/sealed_scan.hpp"

namespace fog::app {

/// Last word of the image, little-endian; unique to the image.
std::uint32_t seal_of_image();

/// Built-in test of image, constants and memory: complete at the start, then repeated, a bounded
/// piece per sample. On a failure while running it restarts the board; the complete test at the
/// start then shows whether the failure is permanent.
class SelfTest {
 public:
  /// `sample_period_us` sets the size of a piece: a pass over image and constants takes 2.5 s of
  /// samples. `constants`: data in RAM that must not change, with their seal. A `table` outside the
  /// image is checked as well. Results go to `token`.
  SelfTest(Span<const std::uint8_t> constants, const ModelTable& table,
           std::uint32_t sample_period_us, IntegrityToken& token);

  /// A token whose life lasts until the next result.
  static IntegrityToken new_token(std::uint32_t sample_period_us);

  /// Runs the complete test. If image or memory is damaged, no rate will be valid.
  void run_all();

  /// Runs the next piece, after a sample was answered.
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
