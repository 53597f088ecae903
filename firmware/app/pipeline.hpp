#pragma once

#include "core/pipeline/compensator.hpp"
#include "core/pipeline/model_parameters.hpp"
#include "fog_model.h"

namespace fog::app {

static_assert(FOG_MODEL_LAYOUT == kModelLayout,
              "fog_model.h is for another version of the firmware: run fogcomp export again");

/// The pipeline with room for what the generated header needs, and no more.
using Pipeline = Compensator<FOG_MODEL_EFFECTS, FOG_MODEL_EXPRESSIONS, FOG_MODEL_NETWORK_INPUTS,
                             FOG_MODEL_TAPS, FOG_MODEL_LEVELS>;

/// The image's weights, checked once.
struct Model {
  Model() : error(read_model({fog_model, FOG_MODEL_WORDS}, Pipeline::room, parameters)) {}
  ModelParameters parameters;
  ModelError error;
};

inline const Model& model() {
  static const Model instance;
  return instance;
}

/// The one pipeline of an image, whichever main runs it. Static, because its filters are larger
/// than the stack.
inline Pipeline& pipeline() {
  static Pipeline instance(model().parameters);
  return instance;
}

}  // namespace fog::app
