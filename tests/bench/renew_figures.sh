#!/usr/bin/env bash
# renew_figures.sh: writes firmware/FIGURES.md anew: what the benchmarks of the firmware print, in the place of figures
# copied into prose. Some ten minutes; the commit shows what changed.
set -euo pipefail
cd "$(dirname "$0")/../.."
source cmake/bootstrap/packages.sh
require_packages "${build_packages[@]}" "${test_packages[@]}" "${bench_packages[@]}" || exit 2
cmake --preset host -DFOG_BENCH=ON -DFOG_TESTS=ON >/dev/null
cmake --build build/host --target fogcomp make_model streaming_worth >/dev/null
page=$(mktemp)
trap 'rm -f "$page"' EXIT
{
  cat <<'EOF'
# Figures of the firmware

Written by `tests/bench/renew_figures.sh`; nothing here is typed. Budgets: [ASSURANCE.md](ASSURANCE.md#stack-size-time).

## What each effect costs

`tests/bench/effect_sizes.sh`: bytes of flash in the STM32F405 image, and instructions of a block of 1 s (mean, max),
that an effect adds beside `bias`. "Itself": a network from scaled inputs to drift, without signals, lags, scaling.

EOF
  tests/bench/effect_sizes.sh
  cat <<'EOF'

## What the denoiser does to noise and to a rotation

`build/host/tests/bench/streaming_worth`; with `docs/examples/mems_chamber.csv` behind it also of a real gyro. It prints
the Allan deviation, too: from 1.3 s on the denoiser changes it by less than 2 %.

```
EOF
  build/host/tests/bench/streaming_worth | sed '/^$/,$d'
  echo '```'
} >"$page"
cp "$page" firmware/FIGURES.md
