#pragma once

#include "core/effects/registry.hpp"
#include "core/pipeline/model_parameters.hpp"

namespace fog {

/// Inputs that a model needs beside the coil temperature.
inline InputMask needs_of(const ModelParameters& parameters) {
  return beside_temperature(needs_of(parameters.effects.enabled()) |
                            inputs_of_expressions(parameters.expressions.used) |
                            inputs_of_network(parameters.network.used()));
}

}  // namespace fog
