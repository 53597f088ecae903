// Prints the results of the checks of tests/on_target on this computer, which every board must
// reproduce.
#include <cstdio>

#include "on_target/checks.hpp"

int main() {
  for (const fog::checks::Check& check : fog::checks::kChecks) {
    std::printf("%s: %s\n", check.name, check.holds() ? "ok" : "FAILED");
  }
  for (const fog::checks::Sweep& sweep : fog::checks::kSweeps) {
    std::printf("%s: 0x%08x\n", sweep.name, static_cast<unsigned>(sweep.crc()));
  }
  return 0;
}
