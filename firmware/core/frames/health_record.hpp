#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/signal/output_sample.hpp"

namespace fog {

/// Words of a health record in their order in the frame.
enum class HealthWord : std::uint8_t {
  model,                   ///< CRC-32 of the model file that the weights come from
  image,                   ///< seal of the image, unique to it
  samples,                 ///< answered since the start, modulo 2^32, as all counts
  invalid_rates,           ///< of these, without a valid undelayed rate
  sequence_gaps,           ///< of these, after lost samples, late, or repeated
  status_last,             ///< Status of the last sample
  status_seen,             ///< of all samples together
  discarded_bytes,         ///< of the sensor stream: part of no good frame
  image_passes,            ///< checks of the whole image since the start
  memory_passes,           ///< tests of the whole memory since the start
  stack,                   ///< size in bytes; from bit 16 on: bytes never written since the start
  rate_delay,              ///< of the KVH frames' rate, or without them the denoised one; samples;
                           ///< from bit 16 on: of the denoiser's low-pass filter tap n / 2 of n
  sample_period,           ///< of the model, us
  version,                 ///< of the firmware: 1.2.3 is 010203
  sources,                 ///< 32 bits of the SHA-256 of the image's sources, without the model
  processor,               ///< three words: unique number of the processor, or 0
  serial = processor + 3,  ///< four: of the gyro; ASCII, padded with at least one 0
  count = serial + 4
};

/// Counters of samples: words of the record.
struct SampleCounts {
  std::uint32_t samples = 0;
  std::uint32_t invalid_rates = 0;
  std::uint32_t sequence_gaps = 0;
  Status status_last = Status::none;
  Status status_seen = Status::none;

  /// Counts a sample.
  void count(const OutputSample& sample) {
    ++samples;
    if (!sample.compensated_valid()) ++invalid_rates;
    if (has_any(sample.status, Status::sequence_gap)) ++sequence_gaps;
    status_last = sample.status;
    status_seen |= sample.status;
  }
};

/// State of a board for diagnosis (SPEC.md, "Health record").
struct HealthRecord {
  bool image_intact = false;     ///< at the start; later failures cause a restart
  bool memory_good = false;      ///< likewise
  std::uint8_t model_error = 0;  ///< a ModelError
  std::array<std::uint32_t, static_cast<std::size_t>(HealthWord::count)> words{};
  std::array<char, 16> reset_cause{};  ///< ASCII, zero-terminated

  std::uint32_t& operator[](HealthWord word) { return words[static_cast<std::size_t>(word)]; }
  std::uint32_t operator[](HealthWord word) const { return words[static_cast<std::size_t>(word)]; }
  Status status_last() const { return static_cast<Status>((*this)[HealthWord::status_last]); }
  Status status_seen() const { return static_cast<Status>((*this)[HealthWord::status_seen]); }
};

constexpr std::size_t kHealthResponseBytes = 112;
using HealthResponse = std::array<std::uint8_t, kHealthResponseBytes>;

HealthResponse encode_health_response(const HealthRecord& record);

/// Reads kHealthResponseBytes bytes, also of images that do not tell their filter. Returns false,
/// and changes nothing, unless sync, layout and CRC are right, all other flags are 0, and serial
/// number and reset cause are terminated.
bool decode_health_response(const std::uint8_t* bytes, HealthRecord& record);

}  // namespace fog
