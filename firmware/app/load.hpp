#pragma once

#include <cstdint>

#include "app/model_table.hpp"

namespace fog::app {

// Tables that come in over the command port (SPEC.md, "Loading a table"), of an image that has its
// model in a slot.

/// Takes a byte of the command port. True while a table comes: nobody else is to have it.
bool take_load_byte(std::uint8_t byte);

/// Whether a table comes. Then no sample is answered, until the board restarts.
bool table_comes();

/// The board restarts when it has a new table, or nothing more has come for a while.
void end_loading();

inline bool is_loading() {
  if constexpr (ModelTable::is_loaded) return table_comes();
  return false;
}

}  // namespace fog::app
