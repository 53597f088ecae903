#pragma once

#include <cstdint>

#include "core/pipeline/model_parameters.hpp"

/* What a sample costs the board at most, in instructions, as a sum over the model: bytes to frames,
   self-test included. Counted by QEMU on the Cortex-M4 image with the longest filters, of tables
   and streams that are dear in one part each (tests/target/sample_bound.sh); the sum is above all
   of them. It holds for each sample but one that (re)starts the model or comes after lost ones.
   Such a sample takes up to three more steps of the model and is less than four times as dear; the
   buffer of the sensor line takes up many. */

namespace fog {

/// Of any sample: parsing, judging, calibration, frames, health, a piece of the self-test.
constexpr std::uint32_t kSampleCost = 4600;
constexpr std::uint32_t kInputCost = 1300;  ///< each needed input: its record, once per sample
constexpr std::uint32_t kLevelCost = 180;   ///< each level of the denoiser ...
constexpr std::uint32_t kTapCost = 10;      ///< ... and each tap of it
/// Writing the state to memory that outlives a restart, with the sample after a block. That of a
/// program's lags and plays is as large as all the rest.
constexpr std::uint32_t kKeepCost = 3400;
constexpr std::uint32_t kKeepProgramCost = 3400;

// A step of the model: thermal state, and for each part of the table ...
constexpr std::uint32_t kStepCost = 400;
constexpr std::uint32_t kEffectCost = 800;
constexpr std::uint32_t kProgramWordCost = 100;
constexpr std::uint32_t kWaveCost = 100;  ///< a sine or cosine, beside its word
constexpr std::uint32_t kNetworkInputCost = 100;
constexpr std::uint32_t kNeuronWordCost = 6;

/// Instructions in 1 us of a sample period: half of what 144 MHz have cycles, because an
/// instruction may take two; less 2 for what a longer period adds to a piece of the self-test.
constexpr std::uint32_t kInstructionsPerUs = 70;

/// Each needed input.
std::uint32_t inputs_cost(const ModelParameters& parameters);
std::uint32_t denoiser_cost(const DenoiseParameters& denoise);
/// One step of the drift model.
std::uint32_t step_cost(const ModelParameters& parameters);
/// Keeping the state.
std::uint32_t keep_cost(const ModelParameters& parameters);
/// What ends a block: the steps of the model, and keeping the state with the next sample. That is
/// the same one if each sample ends a block.
std::uint32_t block_cost(const ModelParameters& parameters);
/// The sum.
std::uint32_t sample_cost(const ModelParameters& parameters);
/// What it may be: the instructions in half a sample period.
std::uint64_t affordable_cost(const ModelParameters& parameters);

}  // namespace fog
