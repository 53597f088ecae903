#include "core/pipeline/model_parameters.hpp"

#include <limits>
#include <new>
#include <type_traits>

#include "core/acquisition/extension_monitor.hpp"
#include "core/bytes/byte_order.hpp"
#include "core/bytes/crc.hpp"
#include "core/effects/effect_bank.hpp"
#include "core/pipeline/table_reader.hpp"

namespace fog {
namespace {

constexpr std::int32_t kMax32 = std::numeric_limits<std::int32_t>::max();
constexpr std::size_t kMinWords = 5;  // magic, layout, word count, provenance, CRC

template <class Value>
Value next_fixed(TableReader& table) {
  return Value::from_raw(table.next());
}

template <class Value>
Value next_positive(TableReader& table) {
  return Value::from_raw(table.next_from(1));
}

void read_calibration(TableReader& table, ModelParameters& parameters) {
  parameters.acquisition.sample_period_us = static_cast<std::uint32_t>(table.next_from(1));
  parameters.acquisition.sample_rate_part =
      static_cast<std::uint32_t>(table.next(1, SampleRateMonitor::kMaxPart));
  parameters.samples_per_block = static_cast<std::uint32_t>(table.next_from(1));
  parameters.calibration.multiplier = table.next_from(1 << 30);
  parameters.calibration.shift = table.next(0, kMaxCalibrationShift);
  parameters.acquisition.rate.range = next_positive<Rate>(table);
  parameters.acquisition.rate.step = next_positive<RateStep>(table);
  parameters.acquisition.stuck.samples = static_cast<std::uint32_t>(table.next_from(0));
  parameters.acquisition.stuck.band = static_cast<std::uint32_t>(table.next_from(0));
}

void read_thermal(TableReader& table, ModelParameters& parameters) {
  auto& thermal = parameters.thermal;
  thermal.derivative.decay = next_positive<FirstOrderLag<BoardNumbers>::Decay>(table);
  thermal.derivative.rate_gain = next_positive<BoardNumbers::Number<24>>(table);
  thermal.min = next_fixed<Temperature>(table);
  thermal.max = next_fixed<Temperature>(table);
  table.require(kMinTemperature <= thermal.min && thermal.min <= thermal.max &&
                thermal.max <= kMaxTemperature);
  parameters.policy.hold_blocks = static_cast<std::uint32_t>(table.next_from(0));
  parameters.policy.accurate_blocks = static_cast<std::uint32_t>(table.next_from(0));
  parameters.policy.settle_blocks = static_cast<std::uint32_t>(table.next_from(0));
}

// Their number is checked by the stages that use them.
void read_input_limits(TableReader& table, AcquisitionParameters& acquisition) {
  acquisition.input_limits =
      table.next_words(kInputLimitWords * table.next_count(kExtensionInputs));
}

// Returns the effects that the table enables.
EffectMask read_effects(TableReader& table, EffectCheck effect_fits, EffectsParameters& effects) {
  effects.coefficient_fraction = table.next(kMinCoefficientFraction, kMaxCoefficientFraction);
  EffectMask enabled = 0;
  for (std::size_t left = table.next_count(kMaxEffects); left > 0 && table.good(); --left) {
    const std::size_t id = table.next_count(kMaxEffects - 1);
    const Span<const std::int32_t> constants = table.next_list(kZeroConstants.size());
    const Span<const std::int32_t> coefficients = table.next_list(kMaxRegressors);
    const EffectMask bit = EffectMask{1} << id;
    table.require((enabled & bit) == 0U && (kAllEffects & bit) != 0U);
    enabled |= bit;
    EffectParameters& effect = effects.by_id[id];
    effect.constants = constants.data;
    effect.coefficients = coefficients;
    if (table.good()) table.require(effect_fits(id, effect, constants.size));
  }
  return enabled;
}

void read_expressions(TableReader& table, ExpressionCheck expressions_fit,
                      ExpressionParameters& expressions) {
  expressions.coefficients = table.next_list(kMaxExpressions);
  expressions.program = table.next_list(kMaxExpressionWords);
  if (!table.good()) return;
  table.require(expressions_fit(expressions));
}

void read_network(TableReader& table, NetworkParameters& network) {
  using Decay = FirstOrderLag<BoardNumbers>::Decay;
  network.input_count = table.next_count(kMaxNetworkInputs);
  const std::size_t hidden = table.next_count(kMaxHidden);
  if (hidden == 0) return;
  table.require(network.input_count > 0);
  for (std::size_t i = 0; i < network.input_count; ++i) {
    InputScaling& input = network.inputs[i];
    input.signal = static_cast<NetworkInput>(table.next(0, kNetworkInputs - 1));
    input.decay = Decay::from_raw(table.next_from(0));
    table.require((input.signal == NetworkInput::lagged_temperature) == (input.decay > Decay{}));
    input.centre = table.next();
    input.half_range = table.next_from(1);
    input.shift = table.next(0, 30);
    table.require(input.half_range <= floor_shift(kMax32, input.shift));
  }
  network.hidden_shift = table.next(0, kMaxWeightShift);
  network.output_shift = table.next(0, kMaxWeightShift);
  network.neurons = table.next_words(kNeuronWords * hidden);
  network.output_bias = table.next();
  network.linear_output = table.next(0, 1) != 0;
  network.centre = next_fixed<NetworkDrift>(table);
  network.amplitude = next_fixed<NetworkDrift>(table);
  table.require(network_fits(network));
}

// Whether both filters pass a constant exactly, the sums over the taps stay below 2^63, and the
// high-pass half of the synthesis belongs to its low-pass half.
bool filters_fit(const DenoiseParameters& denoise) {
  constexpr std::int64_t kHalf = std::int64_t{1} << (kTapFraction - 1);
  constexpr std::int32_t kSynthesisHalf = std::int32_t{1} << (kSynthesisTapFraction - 1);
  const std::size_t taps = denoise.taps();
  const std::int32_t* const low = denoise.low().data;
  const std::int32_t* const synthesis = denoise.synthesis().data;
  std::int64_t phase_sum[2] = {0, 0};
  std::int32_t synthesis_sum[2] = {0, 0};
  std::int64_t magnitude = 0;
  bool same = true;
  for (std::size_t i = 0; i < taps; ++i) {
    const std::int64_t tap = low[i];
    const std::int64_t sign = i % 2 == 0 ? 1 : -1;
    phase_sum[i % 2] += tap;
    magnitude += tap < 0 ? -tap : tap;
    const auto word = static_cast<std::uint32_t>(synthesis[i]);
    const auto mirrored = static_cast<std::uint32_t>(synthesis[taps - 1 - i]);
    synthesis_sum[i % 2] += static_cast<std::int16_t>(word);
    same = same &&
           static_cast<std::int16_t>(word >> 16U) == -sign * static_cast<std::int16_t>(mirrored);
  }
  return same && phase_sum[0] == kHalf && phase_sum[1] == kHalf &&
         synthesis_sum[0] == kSynthesisHalf && synthesis_sum[1] == kSynthesisHalf &&
         magnitude <= kMaxTapSum;
}

void read_denoise(TableReader& table, DenoiseParameters& denoise) {
  const std::size_t levels = table.next_count(kMaxLevels);
  const std::size_t taps = table.next_count(kMaxTaps);
  denoise.rule = static_cast<ThresholdRule>(table.next(0, 2));
  denoise.mode = static_cast<ThresholdMode>(table.next(0, 1));
  denoise.filters = table.next_words(2 * taps);
  denoise.thresholds = table.next_words(levels);
  table.require((levels == 0) == (taps == 0) && taps % 2 == 0);
  if (levels == 0 || !table.good()) return;
  for (const std::int32_t threshold : denoise.thresholds) table.require(threshold >= 0);
  table.require(filters_fit(denoise) && noise_shift(denoise) >= 0);
}

ModelError read_body(Span<const std::int32_t> words, const ModelShape& capacity,
                     ModelParameters& parameters) {
  parameters.fault = Status::none;
  parameters.provenance = static_cast<std::uint32_t>(words[3]);
  constexpr std::size_t kHeaderWords = kProcessorAt + kProcessorWords;
  if (words.size <= kHeaderWords) return ModelError::out_of_range;
  TableReader table({words.data + kHeaderWords, words.size - kHeaderWords - 1});
  table.require(static_cast<std::uint32_t>(words[kProcessorAt - 1]) <
                1U << 24U);  // it is terminated
  read_calibration(table, parameters);
  read_thermal(table, parameters);
  read_input_limits(table, parameters.acquisition);
  const EffectMask enabled = read_effects(table, capacity.effect_fits, parameters.effects);
  read_expressions(table, capacity.expressions_fit, parameters.expressions);
  read_network(table, parameters.network);
  read_denoise(table, parameters.denoise);
  const std::int32_t output = table.next(0, 2 | kAllOutputOptions);
  parameters.output = static_cast<OutputSelection>(output & ~kAllOutputOptions);
  parameters.output_options = static_cast<OutputOptions>(output & kAllOutputOptions);
  table.require(parameters.output <= OutputSelection::both);
  parameters.invalidating = static_cast<Status>(table.next());
  table.require((parameters.invalidating & ~kMayInvalidate) == kRateInvalid);
  parameters.lines = table.next_words(2);
  if (!table.good() || !table.at_end()) return ModelError::out_of_range;
  const ModelError lines = capacity.lines_error(parameters);
  if (lines != ModelError::none) return lines;
  if ((parameters.expressions.used & ~capacity.expressions) != 0U) return ModelError::not_in_image;
  if ((enabled & ~capacity.effects) != 0U ||
      (parameters.network.used() & ~capacity.network_inputs) != 0U ||
      parameters.denoise.levels() > capacity.levels ||
      (capacity.filters >> (parameters.denoise.taps() / 2) & 1U) == 0U ||
      (capacity.output != OutputSelection::both && parameters.output != capacity.output) ||
      (parameters.output_options & ~capacity.output_options) != 0U) {
    return ModelError::not_in_image;
  }
  return capacity.is_affordable(parameters) ? ModelError::none : ModelError::sample_too_dear;
}

// In place: a second object would take a fifth of the stack.
void reset(ModelParameters& parameters) {
  static_assert(std::is_trivially_destructible_v<ModelParameters>);
  new (&parameters) ModelParameters();
}

}  // namespace

ModelParameters::ModelParameters() = default;

ModelError lines_error(const ModelParameters& parameters) {
  const SerialLine output = parameters.output_line();
  if (!parameters.sensor_line().is_valid(kMaxSensorBaud) || !output.is_valid(kMaxOutputBaud)) {
    return ModelError::out_of_range;
  }
  return output.carries(output_bytes(parameters.output), parameters.acquisition.sample_period_us)
             ? ModelError::none
             : ModelError::frames_too_long;
}

std::uint32_t model_table_crc(Span<const std::int32_t> table) {
  std::uint32_t crc = kCrc32Initial;
  for (std::size_t i = 0; i + 1 < table.size; ++i) {
    std::uint8_t bytes[4];
    store_le32(bytes, static_cast<std::uint32_t>(table[i]));
    crc = crc32(bytes, sizeof bytes, crc);
  }
  return crc;
}

ModelError read_model(Span<const std::int32_t> words, const ModelShape& capacity,
                      ModelParameters& parameters) {
  reset(parameters);
  if (words.size < kMinWords || words.size > kMaxModelWords || words[0] != kModelMagic) {
    return ModelError::not_a_model;
  }
  if (words[1] != kModelLayout) return ModelError::other_layout;
  if (static_cast<std::uint32_t>(words[2]) != words.size) return ModelError::damaged;
  if (static_cast<std::uint32_t>(words[words.size - 1]) != model_table_crc(words)) {
    return ModelError::damaged;
  }
  const ModelError error = read_body(words, capacity, parameters);
  if (error != ModelError::none) reset(parameters);
  return error;
}

const char* describe(ModelError error) {
  switch (error) {
    case ModelError::none:
      return "good";
    case ModelError::not_a_model:
      return "missing";
    case ModelError::other_layout:
      return "of another layout";
    case ModelError::damaged:
      return "damaged (CRC)";
    case ModelError::out_of_range:
      return "out of range";
    case ModelError::not_in_image:
      return "not for this image";
    case ModelError::other_board:
      return "of another board";
    case ModelError::other_gyro:
      return "of another gyro";
    case ModelError::frames_too_long:
      return "frames too long";
    case ModelError::sample_too_dear:
      return "sample too dear";
  }
  return "unknown";
}

}  // namespace fog
