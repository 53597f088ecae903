#pragma once

#include <string>

#include "board/board_port.hpp"
#include "board/board_table.hpp"
#include "core/frames/slots_record.hpp"

namespace fogcomp::board {

struct LoadRequest {
  std::string port;           ///< name for messages
  std::string file;           ///< file of the table
  bool another_gyro = false;  ///< allow the table of another gyro than the one in use
  bool serial_given = false;  ///< the user has said which gyro it is: a board may get its first one
};

/// Result: the board's slots after the restart, with the new table in use.
struct LoadedTable {
  std::size_t slot = 0;
  fog::SlotRecord record;
};

/// Loads a table, newer than the one in use, into a board's other slot (firmware/SPEC.md, "Loading
/// a table"), and waits until the board has restarted with it. Throws InputError if the table does
/// not fit this board (checked by the board's own code before anything is sent), if the board
/// refuses it, and if no answer comes.
LoadedTable load_table(BoardPort& port, const BoardTable& table, const LoadRequest& request);

}  // namespace fogcomp::board
