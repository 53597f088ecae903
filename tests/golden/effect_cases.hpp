#pragma once

#include <string>

#include "board/board_table.hpp"
#include "support/typical_effects.hpp"

namespace fog::test {

/// Spacing of the blocks in the golden vectors: a prime, so that all phases of the inputs occur.
constexpr std::size_t kGoldenStride = 2003;

/// Calls visit(name, table) for every effect alone, and first for all of them with a network.
template <class Visit>
void for_each_effect_case(Visit visit) {
  const auto table_of = [](const fogcomp::model::Model& model) {
    return fogcomp::board::make_board_table(model, {200, fog::OutputSelection::kvh, true});
  };
  fogcomp::model::Model model = all_effects_model();
  visit(std::string("all effects and a network"), table_of(model));
  model.network = {};
  for (const fogcomp::model::EffectTerm& term : typical_terms()) {
    model.terms = {term};
    visit(term.name, table_of(model));
  }
}

}  // namespace fog::test
