#!/usr/bin/env bash
# main_job.sh FOGCOMP SOURCE IMAGES: the main job as a user does it. A gyro is recorded, fitted and diagnosed; what the
# diagnosis proposes is typed as it stands until it proposes the export; the flash image with that model gives, for the
# recording, the bytes that this computer gives, and the error has fallen to the noise on a run not seen.
set -euo pipefail
source "$(dirname "$0")/common.sh"
usage="usage: main_job.sh FOGCOMP SOURCE IMAGES"
fogcomp=$(realpath "${1:?$usage}") source=$(realpath "${2:?$usage}") images=${3:?$usage}
enter_scratch
mkdir bin
ln -s "$fogcomp" bin/fogcomp
PATH=$PWD/bin:$PATH

fogcomp simulate -o run.csv >said.txt
fogcomp simulate -o other.csv --profile reversed --seed 2 >said.txt
fogcomp fit run.csv -o gyro.model --effects bias,bias_temperature:order=3 >said.txt
next=
for step in 1 2 3 4 5 6; do
  fogcomp diagnose gyro.model run.csv >said.txt
  next=$(sed -nE 's/^ *next: (fogcomp .*)/\1/p' said.txt | head -n 1)
  echo "step $step: $(head -n 1 said.txt)"
  [[ $next == 'fogcomp add '* ]] || break
  bash -euo pipefail -c "${next/NEW.model/gyro.model}" >added.txt || fail "refused: $next: $(cat added.txt)"
done
[[ $next == 'fogcomp export '* ]] || fail "after $step steps diagnose proposes: $next"

fogcomp compare gyro.model other.csv --json >compare.json
holds compare.json '.runs[0].residual_rms_dph < 1.1 * .runs[0].noise_floor_dph'
echo "left on the other run: $(value compare.json .runs[0].residual_rms_dph) deg/h"

fogcomp export gyro.model -o fog_model.h --sample-rate 0.1 --output both >said.txt
fogcomp replay fog_model.h run.csv -o expected.bin >said.txt
fogcomp stream fog_model.h run.csv -o in.bin >said.txt
"$source/tests/target/header_matches_pc.sh" "$images" "$fogcomp" fog_model.h . stm32f405 in.bin
cmp expected.bin expected_in.bin || fail "the stream of the recording and the recording replay to other bytes"
