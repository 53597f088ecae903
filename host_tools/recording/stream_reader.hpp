#pragma once

#include <string>
#include <string_view>

#include "recording/input_file.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Whether a file that begins with `head` is a captured sensor stream rather than text: it holds a
/// good frame somewhere (damage at the start does not matter), or too many control characters for a
/// CSV.
bool is_sensor_stream(std::string_view head);

/// "damaged bytes 5, late or repeated samples 1"; empty for a capture in good order.
std::string describe(const CaptureCounts& counts);

/// Rows from the frames of a capture, by the board's own parser and its own judge of the sequence
/// numbers (SPEC.md, "Judging a sample"). The first sample's time is its sequence number over the
/// sample rate; from there on time passes as on the board: by one sample and those lost before it,
/// and not at all for a late or repeated one, which makes no row. Samples that never came or are
/// not valid become gaps. Inputs of extension records become columns, each value holding until the
/// next one comes; rows before the first have the first. Period and stretches are left to
/// read_recording. Throws InputError where no good frame is found.
Recording read_sensor_stream(InputFile& file, const ReadOptions& options);

}  // namespace fogcomp::recording
