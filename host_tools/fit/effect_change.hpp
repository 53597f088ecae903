#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace fogcomp::fit {

/// A set of effects after some were added or changed.
struct EffectChange {
  std::vector<model::EffectTerm> terms;
  std::vector<std::size_t> changed;  ///< which of them; none where a network is added
  std::string what;                  ///< as it was asked for; the model's history keeps it
  int network_hidden = 0;            ///< a network of so many hidden neurons is added instead
};

/// What stands for a network on what the effects leave, where an effect is named: `network`, with
/// `:hidden=N` where not 4.
constexpr const char* kNetworkName = "network";

/// `effect`: one effect as `fit --effects` has it. A new one goes to the end. One that is there
/// already keeps its shape but for the parameters that are named: `bias_temperature:order=4` raises
/// the order; with none named it grows by what it can (the next order, a second radius). Throws
/// InputError for anything else than one effect, for an unknown one, and where nothing would
/// change.
EffectChange change_effect(const std::vector<model::EffectTerm>& terms, const std::string& effect);

/// Several effects, one after the other; at least one, none twice. Or a network by itself.
EffectChange change_effects(const std::vector<model::EffectTerm>& terms,
                            const std::vector<std::string>& effects);

/// `definition`: `NAME = EXPRESSION`, a new term at the end. Throws InputError as add_expression()
/// does.
EffectChange change_expression(const std::vector<model::EffectTerm>& terms,
                               const std::string& definition);

}  // namespace fogcomp::fit
