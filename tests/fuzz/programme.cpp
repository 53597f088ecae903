// Chamber programmes that users write by hand.
#include <string>

#include "fuzzing.hpp"
#include "simulation/programme.hpp"
#include "support/input_error.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    fogcomp::simulation::parse_profile(std::string(reinterpret_cast<const char*>(data), size),
                                       "fuzz", 1);
  } catch (const fogcomp::InputError&) {
  }
  return 0;
}
