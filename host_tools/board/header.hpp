#pragma once

#include <string>

#include "board/board_table.hpp"

namespace fogcomp::board {

/// C header of a model table: C99 and C++17, integers only, with macros for what an image needs at
/// compile time. It names its source, but no date.
std::string header_text(const BoardTable& table, const std::string& model_name,
                        std::uint32_t data_hash);

/// Reads the words back. Throws InputError for a file that is not such a header, is damaged or has
/// another layout.
BoardTable parse_header(const std::string& text, const std::string& file);

}  // namespace fogcomp::board
