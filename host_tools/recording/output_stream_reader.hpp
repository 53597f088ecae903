#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "recording/input_file.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// What a board sends (firmware/SPEC.md, "Output streams").
enum class OutputFrames : std::uint8_t {
  kvh,
  compact,  ///< alone, or beside KVH's, which say less
};

/// Whether a file that begins so holds what a board has sent.
std::optional<OutputFrames> find_output_frames(std::string_view head);

/// Reads it as a recording. Compact frames give back the measured rate, which is the compensated
/// one and the drift that was taken off. KVH's have the compensated, denoised rate alone, late by
/// the denoiser's delay, and whole degrees: what that cannot show is told to options.watch. Throws
/// InputError for a stream without a valid sample.
Recording read_output_stream(InputFile& file, OutputFrames frames, const ReadOptions& options);

}  // namespace fogcomp::recording
