// Prints the raw drift (deg/h * 2^10) that the board subtracts, of every effect alone and of all
// with a network, at blocks spread over the verification programme. tests/golden/effect_outputs.txt
// is its output; tests/golden/renew.sh writes that file anew.
#include <cstdio>
#include <string>

#include "board/verification.hpp"
#include "core/compensation/drift_model.hpp"
#include "golden/effect_cases.hpp"

namespace {

void print_outputs(const std::string& name, const fogcomp::board::BoardTable& table) {
  const fog::ModelParameters parameters = fogcomp::board::read_board_table(table, name);
  fog::DriftModel<fog::kAllEffects, fog::kAllExpressions, fog::kAllNetworkInputs> board(
      parameters.thermal, parameters.effects, parameters.expressions, parameters.network,
      parameters.policy);
  std::printf("%s:", name.c_str());
  std::size_t block = 0;
  for (const auto& means :
       fogcomp::board::verification_programme(parameters.thermal.min, parameters.thermal.max, 1)) {
    board.step(means);
    if (block++ % fog::test::kGoldenStride == 0)
      std::printf(" %d", static_cast<int>(board.drift().raw()));
  }
  std::puts("");
}

}  // namespace

int main() {
  fog::test::for_each_effect_case(print_outputs);
  return 0;
}
