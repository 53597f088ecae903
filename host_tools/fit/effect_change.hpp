#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "recording/mask.hpp"

namespace fogcomp::fit {

/// A list of effects after additions or changes.
struct EffectChange {
  std::vector<model::EffectTerm> terms;
  std::vector<std::size_t> changed;    ///< their positions; empty if a network or cuts are added
  std::string what;                    ///< the effects, for the model's history; cuts are the runs'
  int network_hidden = 0;              ///< hidden neurons of a network that is added instead
  std::vector<recording::Cut> cuts{};  ///< of the runs, at which the bias begins anew instead
};

/// Name of cuts, as an addition.
constexpr const char* kCutName = "cut";

/// Name that stands for a network on the residual where an effect is expected: `network`, with
/// `:hidden=N` unless 4.
constexpr const char* kNetworkName = "network";

/// `effect`: one effect in the syntax of `fit --effects`. A new effect is appended. An existing one
/// keeps its shape except for the named parameters: `bias_temperature:order=4` raises the order.
/// Without parameters it is extended (the next order, a second radius). Throws InputError for more
/// than one effect, an unknown one, an event, or if nothing would change.
EffectChange change_effect(const std::vector<model::EffectTerm>& terms, const std::string& effect);

/// Several effects, one after the other; at least one, none twice. Or only a network.
EffectChange change_effects(const std::vector<model::EffectTerm>& terms,
                            const std::vector<std::string>& effects);

/// `definition`: `NAME = EXPRESSION`, appended as a new term. Throws InputError like
/// add_expression().
EffectChange change_expression(const std::vector<model::EffectTerm>& terms,
                               const std::string& definition);

/// The same effects, the bias beginning anew at these times; at least one.
EffectChange change_cuts(const std::vector<model::EffectTerm>& terms,
                         const std::vector<recording::Cut>& cuts);

}  // namespace fogcomp::fit
