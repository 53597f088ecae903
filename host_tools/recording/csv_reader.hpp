#pragma once

#include "recording/input_file.hpp"
#include "recording/line_numbers.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Reads the columns and labels of a CSV (csv_layout.hpp); read_recording sets
/// period and stretches. `lines` gets the line of each row. Throws InputError `FILE:LINE: what is
/// wrong; what to do`.
Recording read_csv(InputFile& file, const ReadOptions& options, LineNumbers& lines);

}  // namespace fogcomp::recording
