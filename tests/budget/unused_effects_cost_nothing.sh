#!/usr/bin/env bash
# unused_effects_cost_nothing.sh ELF: the image of the checked-in model, which has three effects and a network of
# two inputs, holds no code of another effect or of expressions, nor of the functions that only those call.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
symbols=$(arm-none-eabi-nm -C "$1")
# Effects may be inlined to nothing that has a name: the bank's own name says which it was built of.
effects=$(sed -nE 's/^#define FOG_MODEL_EFFECTS (0x[0-9a-f]+)u.*/\1/p' \
  "$(dirname "$0")/../../firmware/model/fog_model.h")
banks=$(grep -oE 'EffectBank<[0-9]+' <<<"$symbols" | sort -u)
[[ $banks == "EffectBank<$((effects))" ]] || fail "$1: effects $effects, but there is: $banks"
used='effects::(Bias|BiasTemperature|TemperatureRate)<'
unused='effects::[A-Z][A-Za-z]*<|ExpressionBank|expressions_fit|sine_cosine|exponential_decay|natural_logarithm|k(Sine|Exponential|Logarithm|Reciprocal)Table'
if found=$(sed -E "s/$used//g" <<<"$symbols" | grep -E "$unused"); then
  echo "$1 holds what its model does not use:" >&2
  fail "$found"
fi
echo "$1: effects $effects, and nothing of those that its model leaves out"
