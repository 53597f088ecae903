#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "recording/input_file.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Whether a file that begins with `head` is a captured sensor stream and not text: it contains a
/// good frame (damage at the start does not matter), or too many control characters for a CSV.
bool is_sensor_stream(std::string_view head);

/// "damaged bytes 5, late or repeated samples 1"; empty for a capture without faults.
std::string describe(const CaptureCounts& counts);

/// Rows from the frames of a capture, by the board's own parser and its checks of the sequence
/// numbers (firmware/spec/samples.md). The first sample's time is its sequence number over the
/// sample rate. From there time advances as on the board: by one sample and those lost before it,
/// and not for a late or repeated one, which makes no row. Lost and invalid samples become gaps.
/// Extension inputs become columns, each value valid until the next one; rows before the first get
/// the first. read_recording sets period and stretches. Throws InputError if there is no good
/// frame.
Recording read_sensor_stream(InputFile& file, const ReadOptions& options);

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
