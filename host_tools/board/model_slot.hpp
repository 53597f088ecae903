#pragma once

#include <cstdint>
#include <string>

#include "board/board_table.hpp"

namespace fogcomp::board {

/// A model table as it lies in a slot of a board with the generic image (firmware/SPEC.md, "Model
/// slots"). Of two in a board the one with the higher `sequence` is the newer. Throws InputError
/// where that image cannot have it: `file` and what it has no room for.
std::string slot_bytes(const BoardTable& table, std::uint32_t sequence, const std::string& file);

/// Whether these are the bytes of a slot, as far as their beginning tells.
bool looks_like_slot(const std::string& bytes);

/// The table in the bytes of a slot. Throws InputError naming `file` where it is damaged or of
/// another layout.
BoardTable parse_slot(const std::string& bytes, const std::string& file);

/// Intel HEX of bytes at the address of slot 0 or 1 of an STM32F405, for a programmer.
std::string slot_hex(const std::string& bytes, unsigned slot);

}  // namespace fogcomp::board
