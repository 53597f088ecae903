#pragma once

#include <cstdint>

#include "app/model_table.hpp"

namespace fog::app {

// Loading of tables over the command port (SPEC.md, "Loading a table"), in images with the model in
// a slot.

/// Takes a byte of the command port. Returns true while a table is loaded: then the byte is not a
/// request.
bool take_load_byte(std::uint8_t byte);

/// Whether a table is being loaded. Then no sample is answered until the board restarts.
bool is_receiving_table();

/// Restarts the board once a new table is complete or no message has come for a while.
void end_loading();

inline bool is_loading() {
  if constexpr (ModelTable::is_loaded) return is_receiving_table();
  return false;
}

}  // namespace fog::app
