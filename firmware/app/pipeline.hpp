#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "app/self_test.hpp"
#include "core/health/image_seal.hpp"
#include "core/pipeline/compensator.hpp"
#include "core/pipeline/model_parameters.hpp"
#include "fog_model.h"
#include "hal/processor.hpp"

namespace fog::app {

static_assert(FOG_MODEL_LAYOUT == kModelLayout,
              "fog_model.h is for another version of the firmware: run fogcomp export again");

/// The pipeline with room for what the generated header needs, and no more.
using Pipeline =
    Compensator<FOG_MODEL_EFFECTS, FOG_MODEL_EXPRESSIONS, FOG_MODEL_NETWORK_INPUTS, FOG_MODEL_TAPS,
                FOG_MODEL_LEVELS, static_cast<OutputSelection>(FOG_MODEL_OUTPUT),
                FOG_MODEL_OUTPUT_OPTIONS>;

/// The image's weights, checked once, and sealed: they are in RAM, and must not change any more.
struct Model {
  Model() : error(read_model({fog_model, FOG_MODEL_WORDS}, Pipeline::room, parameters)) {
    if constexpr (FOG_MODEL_BOUND != 0) refuse_another_board();
    seal = seal_of(crc32(bytes().data, bytes().size - seal.size(), kIntactImage));
  }

  Span<const std::uint8_t> bytes() const {
    const auto* const start = reinterpret_cast<const std::uint8_t*>(this);
    return {start, static_cast<std::size_t>(seal.end() - start)};
  }

  /// The gyro's serial number, ASCII; empty where the table has none. Where it was refused it may
  /// have anything. Out of line: whoever contains it has a table of its own.
  [[gnu::noinline]] static const char* serial() {
    return reinterpret_cast<const char*>(&fog_model[kIdentityAt]);
  }

  ModelParameters parameters;
  ModelError error;
  alignas(4) std::array<std::uint8_t, 4> seal{};  // last

 private:
  void refuse_another_board() {
    if (error != ModelError::none) return;
    if (!is_bound_elsewhere(&fog_model[kProcessorAt], hal::processor_number())) return;
    parameters = ModelParameters();
    error = ModelError::other_board;
  }
};
static_assert(sizeof(Model) == sizeof(ModelParameters) + 8, "nothing lies behind the seal");

inline const Model& model() {
  static const Model instance;
  return instance;
}

/// The one pipeline of an image, whichever main runs it. Static, because its filters are larger
/// than the stack. No rate is valid before the self-test has seen the image.
inline Pipeline& pipeline() {
  static Pipeline instance(model().parameters,
                           SelfTest::new_proof(model().parameters.acquisition.sample_period_us));
  return instance;
}

inline SelfTest& self_test() {
  static SelfTest instance(model().bytes(), model().parameters.acquisition.sample_period_us,
                           pipeline().image_proof());
  return instance;
}

}  // namespace fog::app
