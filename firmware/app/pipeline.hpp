#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "app/model_table.hpp"
#include "app/self_test.hpp"
#include "core/health/image_seal.hpp"
#include "core/pipeline/compensator.hpp"
#include "core/pipeline/model_parameters.hpp"
#include "fog_model.h"

namespace fog::app {

static_assert(FOG_MODEL_LAYOUT == kModelLayout,
              "fog_model.h is for another version of the firmware: run fogcomp export again");

constexpr bool kHasUsualLines = SerialLine(FOG_MODEL_SENSOR_LINE).word() == SerialLine().word() &&
                                SerialLine(FOG_MODEL_OUTPUT_LINE).word() == SerialLine().word();

/// Whether the image has the code for KVH's commands.
constexpr bool kKvhCommands = (FOG_MODEL_OUTPUT_OPTIONS & kAnswersKvhCommands) != 0;

/// The pipeline with the capacity that the generated header needs.
using Pipeline =
    Compensator<FOG_MODEL_EFFECTS, FOG_MODEL_EXPRESSIONS, FOG_MODEL_NETWORK_INPUTS, FOG_MODEL_TAPS,
                FOG_MODEL_LEVELS, static_cast<OutputSelection>(FOG_MODEL_OUTPUT),
                FOG_MODEL_OUTPUT_OPTIONS,
                kHasUsualLines ? usual_lines_error<static_cast<OutputSelection>(FOG_MODEL_OUTPUT)>
                               : lines_error,
                ModelTable::is_loaded ? is_affordable : was_affordable>;

/// The model of the image, checked once and sealed: it is in RAM and must not change any more.
struct Model : ModelTable {
  Model() : error(read(Pipeline::capacity, parameters)) {
    seal = seal_of(crc32(bytes().data, bytes().size - seal.size(), kIntactImage));
  }

  Span<const std::uint8_t> bytes() const {
    const auto* const start = reinterpret_cast<const std::uint8_t*>(this);
    return {start, static_cast<std::size_t>(seal.end() - start)};
  }

  ModelParameters parameters;
  ModelError error;
  alignas(4) std::array<std::uint8_t, 4> seal{};  // last
};
static_assert(sizeof(Model) ==
                  sizeof(ModelParameters) + 8 + (ModelTable::is_loaded ? sizeof(ModelTable) : 0),
              "nothing lies behind the seal");

inline const Model& model() {
  static const Model instance;
  return instance;
}

/// The pipeline of the image. Static, because its filters are larger than the stack. No rate is
/// valid before the self-test has checked the image.
inline Pipeline& pipeline() {
  static Pipeline instance(model().parameters,
                           SelfTest::new_token(model().parameters.acquisition.sample_period_us));
  return instance;
}

/// The lines of the model; the usual ones where there is none.
inline SerialLine sensor_line() {
  return kHasUsualLines ? SerialLine() : model().parameters.sensor_line();
}
inline SerialLine output_line() {
  return kHasUsualLines ? SerialLine() : model().parameters.output_line();
}

// Not inline: each of its users would hold its construction.
[[gnu::noinline]] inline SelfTest& self_test() {
  const Model& used = model();
  static SelfTest instance(used.bytes(), used, used.parameters.acquisition.sample_period_us,
                           pipeline().integrity_token());
  return instance;
}

}  // namespace fog::app
