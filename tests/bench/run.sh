#!/usr/bin/env bash
# All benchmarks of the denoisers, of training, of two inner loops and of a tick of the workbench's page: speed on this
# computer (Google Benchmark, Chromium), instructions on the board (QEMU), the effect of streaming on noise and rotation,
# and the worst error of each function of the core.
set -euo pipefail
cd "$(dirname "$0")/../.."
source cmake/bootstrap/packages.sh
require_packages "${build_packages[@]}" "${test_packages[@]}" "${bench_packages[@]}" || exit 2

cmake --preset host -DFOG_TESTS=ON -DFOG_BENCH=ON -DFOG_WORKBENCH=ON >/dev/null
cmake --build build/host --target wavelet_speed streaming_worth training_speed solver_speed fit_sweep \
  core_functions fogcomp >/dev/null
cmake --preset stm32f405 >/dev/null
cmake --build build/stm32f405 --target denoiser_speed >/dev/null

echo "== this computer, sym8 x 5, 11.9 M samples"
build/host/tests/bench/wavelet_speed 2>/dev/null
# As it is, and with memory as the tool's (support/large_blocks.cpp).
for tunables in "" glibc.malloc.hugetlb=1; do
  GLIBC_TUNABLES=$tunables /usr/bin/python3 - <<'PYTHON'
import os, time
import numpy, pywt

signal = numpy.random.default_rng(1).normal(size=11_900_000)
best_s = float("inf")
for _ in range(5):
    start_s = time.process_time()
    pywt.waverec(pywt.wavedec(signal, "sym8", level=5), "sym8")
    best_s = min(best_s, time.process_time() - start_s)
pages = " with huge pages" if os.environ["GLIBC_TUNABLES"] else ""
print(f"PyWavelets {pywt.__version__}{pages}: transform and inverse {best_s / signal.size * 1e9:.1f} ns a sample")
PYTHON
done
echo
echo "== this computer, training the paper's network (2-10-1, 5955 rows)"
build/host/tests/bench/training_speed 2>/dev/null
echo
echo "== this computer, a thermal step of 200 cells and whitening 6000 rows"
build/host/tests/bench/solver_speed 2>/dev/null
echo
echo "== 2,000 random fits: what they ended with"
build/host/tests/fit_sweep --count 2000 --rows 400 | grep -v ^case
echo
echo "== board, sym8 x 5, instructions per sample"
tests/target/denoiser_speed.sh netduinoplus2 build/stm32f405/denoiser_speed.elf
echo
echo "== the core's functions at all 2^32 arguments: worst error, where, time"
build/host/tests/bench/core_functions
echo
echo "== streaming at 200 Hz"
build/host/tests/bench/streaming_worth docs/examples/mems_chamber.csv
echo
echo "== a tick of the workbench's page, 5955 rows, in Node"
build/host/fogcomp simulate -o build/host/workbench_speed.csv >/dev/null
node tests/bench/workbench_speed.mjs build/host/host_tools/engine/engine.js build/host/workbench_speed.csv
echo
echo "== the same in Chromium, from the click to the painted frame, ms"
build/host/fogcomp fit build/host/workbench_speed.csv -o build/host/workbench_speed.model \
  --effects bias,bias_temperature:order=2,temperature_rate,temperature_rate_product >/dev/null
build/host/fogcomp workbench build/host/workbench_speed.model build/host/workbench_speed.csv \
  -o build/host/workbench_speed.html >/dev/null
node tests/bench/workbench_ticks.mjs build/host/tests/report/browser_driver build/host/workbench_speed.html
