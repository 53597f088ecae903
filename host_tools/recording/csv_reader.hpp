#pragma once

#include "recording/input_file.hpp"
#include "recording/line_numbers.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// The columns and labels of a CSV as contract "Recordings" describes it; period and stretches are
/// left to read_recording. `lines` gets the line of each row. Throws InputError
/// `FILE:LINE: what is wrong; what to do`.
Recording read_csv(InputFile& file, const ReadOptions& options, LineNumbers& lines);

}  // namespace fogcomp::recording
