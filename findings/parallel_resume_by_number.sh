#!/usr/bin/env bash
# Package:  Debian 12 parallel 20221122+ds-2: --joblog with --resume.
# Expected: the commands that the log has as done are left out; a recording that is new in the list is processed.
# Seen:     jobs are told apart by their number in the list. With a new recording in front, that one is never
#           processed, the last one is twice, and the exit code is 0.
# Matters:  a batch over `runs/*.csv` is resumed after more runs were recorded, and a name that sorts early shifts all
#           numbers. The model for that gyro is missing, without an error.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian parallel=20221122+ds-2
export HOME=$PWD
batch() { parallel --will-cite -j1 --joblog log --resume echo fit {} ::: "$@"; }
first=$(batch gyro2 gyro3 gyro4 | paste -sd ' ')
second=$(batch gyro1 gyro2 gyro3 gyro4 | paste -sd ' ')
stated 'first: fit gyro2 fit gyro3 fit gyro4
gyro1 in front: fit gyro4' "first: $first
gyro1 in front: $second"
