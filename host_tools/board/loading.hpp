#pragma once

#include <cstdint>
#include <string>

#include "board/board_port.hpp"
#include "board/board_table.hpp"
#include "core/frames/slots_record.hpp"

namespace fogcomp::board {

struct LoadRequest {
  std::string port;           ///< of which messages speak
  std::string file;           ///< that the table comes from
  bool another_gyro = false;  ///< it may be of another gyro than the one in use
};

/// What the board has made of it: its slots after the restart, the new table in use.
struct LoadedTable {
  std::size_t slot = 0;
  fog::SlotRecord record;
};

/// Loads a table into the slot of a board that is not in use, newer than the one that is
/// (firmware/SPEC.md, "Loading a table"), and waits until the board has restarted with it. Throws
/// InputError where the table is not for this board, before anything is sent, by the code by which
/// the board judges; where the board refuses it; where no answer comes.
LoadedTable load_table(BoardPort& port, const BoardTable& table, const LoadRequest& request);

}  // namespace fogcomp::board
