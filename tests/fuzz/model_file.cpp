// Model files with a right CRC, so that the parser reaches the contents. A file that is read is
// written back unchanged, and its table, if the board can run it, is accepted by the firmware.
#include <string>

#include "board/board_table.hpp"
#include "core/bytes/crc.hpp"
#include "fuzzing.hpp"
#include "model/model_file.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

using fog::test::promise;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string text(reinterpret_cast<const char*>(data), size);
  text = text.substr(0, text.rfind("crc "));
  text += fogcomp::format("crc %08x\n",
                          static_cast<unsigned>(fog::crc32(
                              reinterpret_cast<const std::uint8_t*>(text.data()), text.size())));
  try {
    const fogcomp::model::Model model = fogcomp::model::parse_model(text, "fuzz");
    const std::string written = fogcomp::model::model_text(model);
    promise(fogcomp::model::model_text(fogcomp::model::parse_model(written, "fuzz")) == written,
            "a model that is written is read back");
    fogcomp::board::read_board_table(fogcomp::board::make_board_table(model, {}), "fuzz");
  } catch (const fogcomp::InputError&) {
  }
  return 0;
}
