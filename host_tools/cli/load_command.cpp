// fogcomp load: loads a table into a board with the generic image.

#include <cstdio>
#include <string>

#include "board/board_texts.hpp"
#include "board/loading.hpp"
#include "board/table_files.hpp"
#include "cli/board_options.hpp"
#include "cli/command.hpp"
#include "support/input_error.hpp"
#include "support/json.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

board::BoardTable read_table(const std::string& file) {
  const std::string bytes = read_file(file);
  if (!board::looks_like_slot(bytes)) {
    throw InputError(file,
                     "is no table; fogcomp export MODEL --format table -o GYRO.bin makes one");
  }
  return board::parse_slot(bytes, file);
}

std::string serial_of(const board::BoardTable& table) {
  return board::serial_text(reinterpret_cast<const std::uint32_t*>(&table.words[fog::kIdentityAt]));
}

void print_json(const board::LoadedTable& loaded) {
  const fog::SlotRecord& slot = loaded.record;
  std::puts(Json::object()
                .set("slot", loaded.slot)
                .set("sequence", static_cast<std::int64_t>(slot.sequence))
                .set("model_crc32", format("%08x", slot.model))
                .set("table_crc32", format("%08x", slot.table))
                .set("gyro_serial", board::serial_text(slot.serial.data()))
                .text()
                .c_str());
}

void print_text(const board::LoadedTable& loaded) {
  const fog::SlotRecord& slot = loaded.record;
  const std::string serial = board::serial_text(slot.serial.data());
  std::printf("slot %zu: in use, sequence %u, model CRC-32 %08x, table %08x%s\n", loaded.slot,
              slot.sequence, slot.model, slot.table,
              serial.empty() ? "" : (", of gyro " + displayable(serial)).c_str());
}

struct LoadCommand : Command {
  Text serial{
      this,
      {"serial", "NUMBER", "of the table's gyro, checked; needed for a board's first table", ""}};
  Flag another_gyro{this, "another-gyro",
                    "replace the table of another gyro: the board has been given to this one"};
  BoardLineOption line{this};
  Flag json{this, "json", "one JSON object on stdout"};

  LoadCommand()
      : Command("load", {"PORT TABLE", 2, 2}, "loads a table into a board with the generic image",
                "fogcomp load /dev/ttyUSB0 results/tables/FOG-0042.bin") {}

  int run() const override {
    const std::string& path = arguments[0];
    const std::string& file = arguments[1];
    const board::BoardTable table = read_table(file);
    if (serial.given() && serial_of(table) != serial.value()) {
      throw InputError(file, "is of gyro '" + displayable(serial_of(table)) + "', not of '" +
                                 displayable(serial.value()) + "'");
    }
    board::BoardPort port(path, line.value());
    const board::LoadedTable loaded =
        board::load_table(port, table, {path, file, another_gyro.given(), serial.given()});
    if (json.given()) {
      print_json(loaded);
    } else {
      print_text(loaded);
    }
    return 0;
  }
};

}  // namespace

CommandPointer load_command() {
  return std::make_unique<LoadCommand>();
}

}  // namespace fogcomp::cli
