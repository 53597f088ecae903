#pragma once

#include <cstdint>
#include <string>

#include "board/board_table.hpp"

namespace fogcomp::board {

/// Contents of a slot of a board with the generic image (firmware/SPEC.md, "Model slots") with a
/// model table. Of two slots the one with the higher `sequence` is newer. Throws InputError, naming
/// `file` and the part, if the table exceeds that image's capacity.
std::string slot_bytes(const BoardTable& table, std::uint32_t sequence, const std::string& file);

/// Whether `bytes` begin like a slot.
bool looks_like_slot(const std::string& bytes);

/// The table in the bytes of a slot. Throws InputError naming `file` if it is damaged or has
/// another layout.
BoardTable parse_slot(const std::string& bytes, const std::string& file);

/// Intel HEX of bytes at the address of slot 0 or 1 of an STM32F405, for a programmer.
std::string slot_hex(const std::string& bytes, unsigned slot);

}  // namespace fogcomp::board
