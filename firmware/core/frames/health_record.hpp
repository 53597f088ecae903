#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/signal/output_sample.hpp"

namespace fog {

/// What a board knows about itself (SPEC.md, "Health record").
struct HealthRecord {
  bool image_intact = false;  ///< at the start; what is found later ends in a restart
  bool memory_good = false;   ///< likewise
  bool model_good = false;
  std::uint32_t model = 0;            ///< CRC-32 of the model file that the weights come from
  std::uint32_t image_crc = 0;        ///< at the start; kIntactImage
  std::uint32_t samples = 0;          ///< answered since the start, modulo 2^32, as all counts
  std::uint32_t invalid_rates = 0;    ///< of these, without a valid undelayed rate
  std::uint32_t sequence_gaps = 0;    ///< of these, after lost samples, late, or repeated
  std::uint32_t discarded_bytes = 0;  ///< of the sensor stream: part of no good frame
  Status status_last = Status::none;  ///< of the last sample
  Status status_seen = Status::none;  ///< of all samples together
  std::uint32_t image_passes = 0;     ///< checks of the whole image since the start
  std::uint32_t memory_passes = 0;    ///< tests of the whole memory since the start
  std::uint16_t stack_bytes = 0;
  std::uint16_t stack_unused_bytes = 0;  ///< never written since the start
  std::array<char, 16> reset_cause{};    ///< ASCII, zero-terminated

  /// Counts a sample.
  void count(const OutputSample& sample) {
    ++samples;
    if (!sample.compensated_valid()) ++invalid_rates;
    if (any(sample.status, Status::sequence_gap)) ++sequence_gaps;
    status_last = sample.status;
    status_seen |= sample.status;
  }
};

constexpr std::size_t kHealthResponseBytes = 68;
using HealthResponse = std::array<std::uint8_t, kHealthResponseBytes>;

HealthResponse encode_health_response(const HealthRecord& record);

/// Reads kHealthResponseBytes bytes; false, with nothing changed, unless sync, layout and CRC are
/// right, all other flags are 0 and the reset cause ends.
bool decode_health_response(const std::uint8_t* bytes, HealthRecord& record);

}  // namespace fog
