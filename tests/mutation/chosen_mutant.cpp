// Linked into every mutated program: which mutant it is, from the environment; 0 is none.
#include <cstdlib>

int fog_mutant = 0;

namespace {

[[gnu::constructor(101)]] void choose() {
  const char* number = std::getenv("FOG_MUTANT");
  if (number != nullptr) fog_mutant = std::atoi(number);
}

}  // namespace
