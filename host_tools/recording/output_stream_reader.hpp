#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "recording/input_file.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Output stream of a board (firmware/SPEC.md, "Output streams").
enum class OutputFrames : std::uint8_t {
  kvh,
  compact,  ///< alone, or with KVH frames, which contain less
};

/// The kind of output stream that `head` begins, if any.
std::optional<OutputFrames> find_output_frames(std::string_view head);

/// Reads it as a recording. Compact frames give the measured rate: compensated rate plus drift. KVH
/// frames contain only the compensated, denoised rate, delayed by the denoiser, and whole degrees;
/// the limitations are reported to options.watch. Throws InputError for a stream without a valid
/// sample.
Recording read_output_stream(InputFile& file, OutputFrames frames, const ReadOptions& options);

}  // namespace fogcomp::recording
