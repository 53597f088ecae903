// Expressions that users write by hand.
#include <string>

#include "fuzzing.hpp"
#include "model/expression.hpp"
#include "support/input_error.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    fogcomp::model::parse_expression(std::string(reinterpret_cast<const char*>(data), size));
  } catch (const fogcomp::InputError&) {
  }
  return 0;
}
