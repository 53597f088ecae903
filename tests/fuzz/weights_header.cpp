// Exported headers as text.
#include <string>

#include "board/table_files.hpp"
#include "fuzzing.hpp"
#include "support/input_error.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    fogcomp::board::parse_header(std::string(reinterpret_cast<const char*>(data), size), "fuzz");
  } catch (const fogcomp::InputError&) {
  }
  return 0;
}
