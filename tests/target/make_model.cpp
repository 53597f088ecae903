// make_model OUT.model [EFFECT]: a model of one effect at its typical size, or of all that a board
// can have and a network of 10 neurons. For the images of the target tests and of tests/bench.
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/model_file.hpp"
#include "support/typical_effects.hpp"

namespace {

// Ten neurons with inputs spread over the range; the sample model's three would be cheaper to run.
void widen_network(fogcomp::RealNetwork& network) {
  constexpr int kHidden = 10;
  network.hidden.weights.resize(kHidden, 2);
  network.hidden.biases.resize(kHidden);
  network.output.weights.resize(1, kHidden);
  for (int i = 0; i < kHidden; ++i) {
    network.hidden.weights.row(i) << 5.0 * (i % 3 - 1) + 1, 3.0 - i;
    network.hidden.biases[i] = 0.5 * i - 2;
    network.output.weights(0, i) = (i % 2 == 0 ? 0.4 : -0.3);
  }
}

fogcomp::EffectTerm typical_term(const std::string& name) {
  for (const fogcomp::EffectTerm& term : fog::test::typical_terms()) {
    if (term.name == name) return term;
  }
  throw std::invalid_argument("no effect '" + name + "' that a board can have");
}

void run(const std::string& output, const std::vector<std::string>& effects) {
  fogcomp::Model model = fog::test::all_effects_model();
  if (effects.empty()) {
    widen_network(model.network);
  } else {
    model.network = {};
    model.terms.clear();
    for (const std::string& effect : effects) model.terms.push_back(typical_term(effect));
  }
  fogcomp::save_model(model, output);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: make_model OUT.model [EFFECT...]\n", stderr);
    return 2;
  }
  try {
    run(argv[1], {argv + 2, argv + argc});
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_model: %s\n", error.what());
    return 1;
  }
}
