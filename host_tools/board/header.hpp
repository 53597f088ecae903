#pragma once

#include <string>

#include "board/board_table.hpp"

namespace fogcomp::board {

/// The C header of a model table: C99 and C++17, integers only, with what an image needs to know at
/// compile time as macros. Says from what it was made, never when.
std::string header_text(const BoardTable& table, const std::string& model_name,
                        std::uint32_t data_hash);

/// Reads the words back. Throws InputError for a file that is no such header, is damaged or of
/// another layout.
BoardTable parse_header(const std::string& text, const std::string& file);

}  // namespace fogcomp::board
