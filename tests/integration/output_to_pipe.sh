#!/usr/bin/env bash
# output_to_pipe.sh FOGCOMP: -o may name a pipe: it gets the bytes that a file would, and stays a pipe. (Found with
# a device: -o /dev/null, run as root, put a file in its place.)
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: output_to_pipe.sh FOGCOMP}")
enter_scratch

"$fogcomp" simulate -o run.csv >said.txt
mkfifo pipe
timeout 60 cat pipe >piped.csv &
timeout 60 "$fogcomp" simulate -o pipe >said.txt
wait
cmp run.csv piped.csv
[[ -p pipe ]] || fail "the pipe is gone"
[[ $(ls) == $'pipe\npiped.csv\nrun.csv\nsaid.txt' ]] || fail "the folder has: $(ls)"
echo "a pipe gets the file's bytes and stays a pipe"
