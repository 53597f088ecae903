// Prints the raw drift (deg/h * 2^10) that the board subtracts, of every effect alone and of all
// with a network, at blocks spread over the verification programme. tests/golden/effect_outputs.txt
// is its output; tests/golden/renew.sh writes that file anew.
#include <cstdio>
#include <string>

#include "core/compensation/drift_model.hpp"
#include "quantization/verification_programme.hpp"
#include "support/typical_effects.hpp"

namespace {

constexpr std::size_t kStride = 2003;  // blocks, a prime: falls on every phase of every input

void print_outputs(const std::string& name, const fogcomp::Model& model) {
  const fogcomp::BoardTable table =
      fogcomp::make_board_table(model, {200, fog::OutputSelection::kvh, true});
  const fog::ModelParameters parameters = fogcomp::read_board_table(table, name);
  fog::DriftModel<fog::kAllEffects, fog::kAllExpressions, fog::kAllNetworkInputs> board(
      parameters.thermal, parameters.effects, parameters.expressions, parameters.network,
      parameters.policy);
  std::printf("%s:", name.c_str());
  std::size_t block = 0;
  for (const auto& means :
       fogcomp::verification_programme(parameters.thermal.least, parameters.thermal.most, 1)) {
    board.step(means);
    if (block++ % kStride == 0) std::printf(" %d", static_cast<int>(board.drift().raw()));
  }
  std::puts("");
}

}  // namespace

int main() {
  fogcomp::Model model = fog::test::all_effects_model();
  print_outputs("all effects and a network", model);
  model.network = {};
  for (const fogcomp::EffectTerm& term : fog::test::typical_terms()) {
    model.terms = {term};
    print_outputs(term.name, model);
  }
  return 0;
}
