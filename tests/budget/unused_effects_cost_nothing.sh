#!/usr/bin/env bash
# unused_effects_cost_nothing.sh ELF: the image of the checked-in model, which has three effects and a network of
# two inputs, holds no code of another effect or of expressions, nor of the functions that only those call.
set -euo pipefail
symbols=$(arm-none-eabi-nm -C "$1")
unused='effects::(Shupe|ThermalLag|TemperatureRateProduct|AxialGradient|PolarizationRipple|ThermalHysteresis|GlassTransition|ScaleFactorTemperature|WarmUp|Aging|Magnetic|Vibration|LightPower|BiasStep)|ExpressionBank|expressions_fit|sine_cosine|exponential_decay|natural_logarithm|k(Sine|Exponential|Logarithm|Reciprocal)Table'
if found=$(grep -E "$unused" <<<"$symbols"); then
  echo "$1 holds what its model does not use:" >&2
  echo "$found" >&2
  exit 1
fi
grep -q 'kLogisticTable' <<<"$symbols" || { echo "no symbols in $1" >&2; exit 1; }
echo "$1: nothing of the effects that its model leaves out"
