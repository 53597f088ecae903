#include "core/pipeline/sample_cost.hpp"

#include "core/pipeline/model_needs.hpp"

namespace fog {
namespace {

std::uint32_t count_of(std::uint32_t mask) {
  std::uint32_t count = 0;
  for (; mask != 0; mask &= mask - 1) ++count;
  return count;
}

std::uint32_t network_cost(const NetworkParameters& network) {
  if (!network.present()) return 0;
  return kNetworkInputCost * static_cast<std::uint32_t>(network.input_count) +
         kNeuronWordCost * static_cast<std::uint32_t>(network.neurons.size);
}

// The dearest table that the other checks let pass.
constexpr std::uint32_t kMaxStepCost =
    kStepCost + kEffectCost * kMaxEffects + (kProgramWordCost + kWaveCost) * kMaxExpressionWords +
    kNetworkInputCost * kMaxNetworkInputs + kNeuronWordCost * kNeuronWords * kMaxHidden;
static_assert(kMaxStepCost <= UINT32_MAX / 2 / kMaxCatchUpSteps, "sums fit");

}  // namespace

std::uint32_t inputs_cost(const ModelParameters& parameters) {
  return kInputCost * count_of(needs_of(parameters) & kAllExtensionInputs);
}

std::uint32_t denoiser_cost(const DenoiseParameters& denoise) {
  const auto taps = static_cast<std::uint32_t>(denoise.taps());
  return static_cast<std::uint32_t>(denoise.levels()) * (kLevelCost + kTapCost * taps);
}

std::uint32_t step_cost(const ModelParameters& parameters) {
  const auto program_words = static_cast<std::uint32_t>(parameters.expressions.program.size);
  return kStepCost + kEffectCost * count_of(parameters.effects.enabled()) +
         kProgramWordCost * program_words + kWaveCost * parameters.expressions.waves +
         network_cost(parameters.network);
}

std::uint32_t keep_cost(const ModelParameters& parameters) {
  return kKeepCost + (parameters.expressions.program.size == 0 ? 0 : kKeepProgramCost);
}

std::uint32_t block_cost(const ModelParameters& parameters) {
  const std::uint32_t steps = parameters.catch_up_steps() * step_cost(parameters);
  const std::uint32_t keep = keep_cost(parameters);
  if (parameters.samples_per_block == 1) return steps + keep;
  return steps > keep ? steps : keep;
}

std::uint32_t sample_cost(const ModelParameters& parameters) {
  return kSampleCost + inputs_cost(parameters) + denoiser_cost(parameters.denoise) +
         block_cost(parameters);
}

std::uint64_t affordable_cost(const ModelParameters& parameters) {
  return std::uint64_t{kInstructionsPerUs} * parameters.acquisition.sample_period_us;
}

bool is_affordable(const ModelParameters& parameters) {
  return sample_cost(parameters) <= affordable_cost(parameters);
}

}  // namespace fog
