#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/acquisition/calibration.hpp"
#include "core/acquisition/sample_monitor.hpp"
#include "core/compensation/drift_policy.hpp"
#include "core/denoise/denoise_parameters.hpp"
#include "core/effects/effect_parameters.hpp"
#include "core/expression/expression_bank.hpp"
#include "core/frames/output_bytes.hpp"
#include "core/frames/serial_line.hpp"
#include "core/network/network.hpp"
#include "core/signal/span.hpp"
#include "core/signal/status.hpp"
#include "core/thermal/thermal_state.hpp"

namespace fog {

/// Frames sent for each sample.
enum class OutputSelection : std::uint8_t { kvh = 0, compact = 1, both = 2 };

/// Options of the KVH frames: bits of the same word of the table.
using OutputOptions = std::uint8_t;
constexpr OutputOptions kRotationIsAngle = 4;  ///< Z rotation is the angle of a sample, not a rate
constexpr OutputOptions kAnswersKvhCommands = 8;
constexpr OutputOptions kRotationIsUndelayed = 16;  ///< it is the undelayed rate, or its angle
constexpr OutputOptions kAllOutputOptions =
    kRotationIsAngle | kAnswersKvhCommands | kRotationIsUndelayed;

/// Bytes sent for each sample.
constexpr std::size_t output_bytes(OutputSelection output) {
  return (output == OutputSelection::compact ? 0 : kKvhFrameBytes) +
         (output == OutputSelection::kvh ? 0 : kCompactFrameBytes);
}

constexpr std::int32_t kModelMagic = 0x464F474D;  ///< "FOGM"
constexpr std::int32_t kModelLayout = 9;          ///< of the table; SPEC.md, "Model table"
constexpr std::size_t kMaxModelWords = 4096;
constexpr std::uint32_t kMaxCatchUpSteps = 64;

struct ModelParameters;
enum class ModelError : std::uint8_t;

/// Checks the lines of a table, which are there, and whether the frames of a sample fit into its
/// period.
using LinesCheck = ModelError (*)(const ModelParameters& parameters);
ModelError lines_error(const ModelParameters& parameters);

/// Whether the board can compute a sample of a table in time (sample_cost.hpp).
using CostCheck = bool (*)(const ModelParameters& parameters);
bool is_affordable(const ModelParameters& parameters);
/// Stub for an image of one table: `fogcomp export`, which wrote it, has checked its cost.
inline bool was_affordable(const ModelParameters& /*parameters*/) {
  return true;
}

/// Capacity of an image, fixed by the header that it is built with.
struct ModelShape {
  EffectMask effects = 0;
  ExpressionMask expressions = 0;
  NetworkInputMask network_inputs = 0;
  FilterMask filters = 0;  ///< lengths of which it has the denoiser
  std::size_t levels = 0;  ///< at most
  EffectCheck effect_fits = any_effect_fits;
  ExpressionCheck expressions_fit = fog::expressions_fit;
  OutputSelection output = OutputSelection::both;  ///< these frames; both: whatever
  OutputOptions output_options = kAllOutputOptions;
  LinesCheck lines_error = fog::lines_error;
  CostCheck is_affordable = fog::is_affordable;
};

/// The effects of any model: read_model() refuses those that no board can run.
constexpr EffectMask kAnyEffects = ~EffectMask{0};

/// Capacity for any model.
constexpr ModelShape kAnyModel{kAnyEffects, kAllExpressions, kAllNetworkInputs,
                               filters_of(kAnyTaps), kMaxLevels};

/// The owner of a model, from word kIdentityAt of the table on: four words of the gyro's serial
/// number, ASCII padded with 0, terminated by at least one 0; three words of the number of the
/// processor that it is bound to, all 0 if it is not bound.
constexpr std::size_t kIdentityAt = 4;
constexpr std::size_t kSerialWords = 4;
constexpr std::size_t kProcessorWords = 3;
constexpr std::size_t kProcessorAt = kIdentityAt + kSerialWords;

/// Whether a table is bound to another processor than this one.
inline bool is_bound_elsewhere(const std::int32_t* bound,
                               const std::array<std::uint32_t, kProcessorWords>& processor) {
  std::uint32_t any = 0;
  std::uint32_t difference = 0;
  for (std::size_t i = 0; i < kProcessorWords; ++i) {
    any |= static_cast<std::uint32_t>(bound[i]);
    difference |= static_cast<std::uint32_t>(bound[i]) ^ processor[i];
  }
  return any != 0 && difference != 0;
}

/// A decoded model table. Arrays stay in the table, which must outlive this object. By default the
/// parameters of a board without a usable model: no rate is valid.
struct ModelParameters {
  ModelParameters();  // not inline: saves 130 bytes of flash

  Status fault = Status::model_refused;  ///< part of the status of every sample
  std::uint32_t provenance = 0;          ///< CRC-32 of the model file that it was made from
  std::uint32_t samples_per_block = 1;
  CalibrationParameters calibration;
  AcquisitionParameters acquisition;
  ThermalParameters<BoardNumbers> thermal;
  DriftPolicy policy;
  EffectsParameters effects;
  ExpressionParameters expressions;
  NetworkParameters network;
  DenoiseParameters denoise;
  OutputSelection output = OutputSelection::kvh;
  OutputOptions output_options = 0;
  Status invalidating = kRateInvalid;  ///< any of these flags makes a rate invalid
  Span<const std::int32_t> lines;      ///< sensor, output; empty: the usual ones

  SerialLine sensor_line() const { return line(0); }
  SerialLine output_line() const { return line(1); }

  /// Steps of the drift model per sample, so that it has caught up with any hold before the next
  /// block ends. One, if a block has more samples than a hold has blocks.
  std::uint32_t catch_up_steps() const {
    const std::uint32_t steps = policy.hold_blocks / samples_per_block;
    return steps < kMaxCatchUpSteps ? steps + 1 : kMaxCatchUpSteps;
  }

 private:
  SerialLine line(std::size_t index) const {
    return lines.size == 0 ? SerialLine() : SerialLine(static_cast<std::uint32_t>(lines[index]));
  }
};

/// Reasons to refuse a table.
enum class ModelError : std::uint8_t {
  none,
  not_a_model,      ///< no magic number, or too short or long
  other_layout,     ///< made for another version of the firmware
  damaged,          ///< CRC
  out_of_range,     ///< a value that no export writes
  not_in_image,     ///< an effect, operation, network input or filter that this image was not built
                    ///< for
  other_board,      ///< bound to another processor
  other_gyro,       ///< in the older slot, of another gyro than the newer one
  frames_too_long,  ///< the frames of a sample take longer on the output line than a sample period
  sample_too_dear,  ///< a sample may take longer to compute than half a sample period
};

/// The check of an image whose header has the usual lines, 921600 8N1: it takes less flash.
template <OutputSelection kOutput>
ModelError usual_lines_error(const ModelParameters& parameters) {
  constexpr auto kUsual = static_cast<std::int32_t>(SerialLine().word());
  if (((parameters.lines[0] ^ kUsual) | (parameters.lines[1] ^ kUsual)) != 0) {
    return ModelError::not_in_image;
  }
  constexpr std::uint32_t kMinPeriodUs = SerialLine().us_of(output_bytes(kOutput));
  return parameters.acquisition.sample_period_us < kMinPeriodUs ? ModelError::frames_too_long
                                                                : ModelError::none;
}

/// The last word of a table: CRC-32 of the words before it.
std::uint32_t model_table_crc(Span<const std::int32_t> table);

/// Checks everything once, so that the pipeline need not: CRC, layout, ranges, and sums that must
/// not overflow. On an error `parameters` are as constructed.
ModelError read_model(Span<const std::int32_t> table, const ModelShape& capacity,
                      ModelParameters& parameters);

/// Text for the boot message and the host's errors.
const char* describe(ModelError error);

}  // namespace fog
