#!/usr/bin/env bash
# planted_faults.sh: plants a fault in a copy of each module of the core, one at a time, and sees the proof of its bounds
# find it: the compiler a broken static_assert, the intervals an operation that can overflow, the sweep an error that is
# larger than the documented one.
set -euo pipefail
cd "$(dirname "$0")/../.."
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
: "${CXX:=g++}"
compile=("$CXX" -std=c++17 -O0 -w -I"$copy/firmware" -I"$copy/tests")
functions=(fixed_point/{exponential,logarithm,logistic,rounded_product,sine} frames/rate_float thermometer/platinum)

compiles() { "${compile[@]}" -fsyntax-only "$copy/firmware/core/$1" 2>"$copy/said.txt"; }
# runs TEST SOURCE...
runs() {
  "${compile[@]}" "$copy/tests/$1" "${@:2}" -lgtest -lgtest_main -lpthread -o "$copy/program" ||
    { echo "FAILED: $1 does not compile: nothing is shown"; exit 1; }
  "$copy/program" --gtest_brief=1 >"$copy/said.txt" 2>&1
}
holds() {
  local sources=("${functions[@]/#/$copy/firmware/core/}")
  case $1 in
    intervals) runs proof/effects_proof_test.cpp "$copy/functions.a" ;;
    sweep) runs unit/core/core_functions_test.cpp "${sources[@]/%/.cpp}" ;;
    *) compiles "$1" ;;
  esac
}

failures=0
# change FILE FROM TO: in the copy of firmware/core/FILE.
change() { tests/proof/plant.py "$copy/firmware/core/$1" "$2" "$3"; }

# found IS_IT WHERE WHAT
found() {
  if (($1)); then
    echo "found: $2: $3"
  else
    echo "FAILED: not found: $2: $3"
    failures=$((failures + 1))
  fi
}

# plant CHECK FILE FROM TO: one fault, in a fresh copy.
plant() {
  cp -r firmware/core "$copy/firmware/"
  change "${@:2}"
  local is_found=1
  if holds "$1"; then is_found=0; fi
  found "$is_found" "$2" "$4"
}

# plant_in SAID FILE FROM TO: the intervals name the effect whose operation can overflow, so faults of several effects are
# planted at once, and looked for by find_planted.
planted=()
plant_in() {
  ((${#planted[@]})) || cp -r firmware/core "$copy/firmware/"
  change "${@:2}"
  planted+=("$1" "$2" "$4")
}
find_planted() {
  local i
  if holds intervals; then echo "no interval overflows" >"$copy/said.txt"; fi
  for ((i = 0; i < ${#planted[@]}; i += 3)); do
    found "$(grep -c -m 1 -e "${planted[i]}" "$copy/said.txt" || true)" "${planted[@]:i+1:2}"
  done
}

mkdir -p "$copy/firmware"
cp -r firmware/core "$copy/firmware/"
mkdir -p "$copy/tests/unit"
cp -r tests/proof tests/sweep tests/support "$copy/tests/"
cp -r tests/unit/core "$copy/tests/unit/"
for function in "${functions[@]}"; do
  "${compile[@]}" -c "$copy/firmware/core/$function.cpp" -o "$copy/${function//\//_}.o"
done
ar rc "$copy/functions.a" "$copy"/*.o
for check in intervals sweep acquisition/calibration.hpp compensation/drift_model.hpp network/network.cpp denoise/denoise_parameters.cpp denoise/filter_bank.cpp; do
  holds "$check" || { cat "$copy/said.txt"; echo "FAILED: $check: a fault where none is planted"; exit 1; }
done

# What a table may say, in each module that reads it.
plant denoise/denoise_parameters.cpp denoise/denoise_parameters.hpp '2 * power_of_two<std::int64_t>(kTapFraction)' '3 * power_of_two<std::int64_t>(kTapFraction)'
plant denoise/denoise_parameters.cpp denoise/denoise_parameters.cpp 'kMaxGain = UINT16_MAX' 'kMaxGain = 2 * UINT16_MAX'
plant denoise/denoise_parameters.cpp denoise/denoise_parameters.cpp '(30) - 1' '(30)* 2'
plant denoise/denoise_parameters.cpp denoise/denoise_parameters.hpp 'kMaxNoiseShift = 15' 'kMaxNoiseShift = 16'
plant denoise/filter_bank.cpp denoise/denoise_parameters.hpp 'kMaxThresholdScale = 4' 'kMaxThresholdScale = 5'
plant denoise/filter_bank.cpp denoise/adaptive_thresholds.hpp 'kEnergyUnit = 256' 'kEnergyUnit = 128'
plant denoise/filter_bank.cpp denoise/outlier_gate.hpp '(30) - 1' '(31)'
plant denoise/filter_bank.cpp denoise/filter_kernels.hpp 'kTapFraction + Rate::fractional_bits - kDetailFraction' 'kTapFraction + kDetailFraction - Rate::fractional_bits'
plant denoise/adaptive_thresholds.cpp denoise/adaptive_thresholds.cpp 'kNoiseVariance = 422' 'kNoiseVariance = 422 << 14'
plant network/network.cpp network/network.cpp 'kMaxWeightSum = UINT32_MAX - 1' 'kMaxWeightSum = UINT32_MAX'
plant network/network.cpp network/network.hpp 'kMaxWeightShift = 16' 'kMaxWeightShift = 23'
plant pipeline/model_parameters.cpp signal/weighted_sum.hpp 'Fixed<std::int64_t, 20>' 'Fixed<std::int64_t, 34>'
plant pipeline/model_parameters.cpp effects/effect_parameters.hpp 'kMaxCoefficientFraction = 40' 'kMaxCoefficientFraction = 55'
plant pipeline/model_parameters.cpp effects/effect_parameters.hpp '= Rate::fractional_bits;' '= 6;'
plant expression/expression_program.cpp expression/expression_program.hpp 'kMaxLeftShift = 31' 'kMaxLeftShift = 32'
plant expression/expression_program.cpp expression/expression_program.hpp 'kMaxDivideBits = 30' 'kMaxDivideBits = 31'
plant frames/delta_angle.cpp frames/delta_angle.hpp 'kAnglePerLsbUs = 5723669695U' 'kAnglePerLsbUs = 2 * 5723669695U'
plant frames/rate_float.cpp frames/rate_float.cpp '= 2729258392U' '= 2729258392U * std::uint64_t{4}'
plant acquisition/rate_monitor.cpp acquisition/rate_monitor.cpp 'kMaxElapsedSamples = 1U << 30U' 'kMaxElapsedSamples = 3U << 30U'
plant acquisition/rate_monitor.cpp acquisition/rate_monitor.hpp 'Rate::fractional_bits - 1>' 'Rate::fractional_bits - 2>'
plant acquisition/calibration.hpp acquisition/calibration.hpp 'kMaxCalibrationShift = 62' 'kMaxCalibrationShift = 63'
plant compensation/drift_model.hpp compensation/drift_model.hpp 'RateDrift::fractional_bits - Rate' 'RateDrift::fractional_bits + 1 - Rate'
plant thermal/block_average.hpp fixed_point/shift.hpp '::max()) / 2' '::max()) / 4'
plant thermometer/platinum.cpp thermometer/platinum.cpp 'Celsius::fractional_bits + Slope' 'Celsius::fractional_bits + 6 + Slope'
plant fixed_point/logarithm.cpp fixed_point/logarithm.cpp '= 762123384786' '= 2 * 762123384786'
# Operations and checks of constants.
plant_in '^-axial_gradient: ' effects/axial_gradient.hpp 'N::saturating_difference(second, signals.block.temperature)' 'second - signals.block.temperature'
plant_in '^-bias_temperature: ' effects/bias_temperature.hpp 'saturate_to<Regressor>(power * x)' 'round_to<Regressor>(power * x)'
plant_in '^-vibration: ' effects/vibration.hpp 'saturate_to' 'round_to'
plant_in '^-glass_transition: ' effects/glass_transition.hpp '256 << 22' '400 << 22'
plant_in '^-thermal_hysteresis: ' effects/thermal_hysteresis.hpp '256 << 22' '400 << 22'
plant_in '^-scale_factor_asymmetry: ' effects/scale_factor_asymmetry.hpp '3 * power_of_two' '5 * power_of_two'
plant_in '^-scale_factor_temperature: ' effects/scale_factor_temperature.hpp 'kMaxReference = 256' 'kMaxReference = 32767'
plant_in '^-scale_factor: ' effects/scale_factor.hpp 'scale_factor_error<N, 1>' 'scale_factor_error<N, 0>'
plant_in '^-aging: ' effects/aging.hpp 'if (age_ > longest) age_ = longest;' ''
plant_in '^-light_power: ' effects/light_power.hpp 'power < min ? min : power' 'power'
plant_in '^-polarization_ripple: ' effects/polarization_ripple.hpp 'Stretched = typename N::template Number<23>' 'Stretched = typename N::template Number<24>'
plant_in '\[  FAILED  \] ThermalState' thermal/filtered_derivative.hpp 'saturate_to<TemperatureRate>' 'round_to<TemperatureRate>'
find_planted
plant expression/expression_program.cpp expression/expression_program.hpp 'kMaxPlayRadius = (1 << 30) - 1' 'kMaxPlayRadius = 1 << 30'
# Functions.
plant sweep fixed_point/sine_table.hpp 105245103 105245105
plant sweep fixed_point/exponential_table.hpp 1028218693 1028218696
plant sweep fixed_point/logarithm_table.hpp 65095192 65095195
plant sweep fixed_point/logistic.hpp 0x05555555 0x05595555
plant sweep fixed_point/shift.hpp 'Int{1} << bits' 'Int{1} << (bits & 30)'
plant sweep fixed_point/rounded_product.cpp 'round_shift' 'floor_shift'
plant sweep frames/rate_float.cpp 2729258392U 2729258992U
plant sweep thermometer/platinum.cpp 268576331 268577331
exit $((failures > 0))
