#!/usr/bin/env bash
# fuzz.sh FUZZER SEEDS DIR OPTION...: runs a fuzzer from SEEDS, with what it finds on its way kept in DIR/corpus. What
# breaks it is DIR/broken-*; give that to FUZZER to see it again. Prints how much was tried.
set -euo pipefail
fuzzer=$1 seeds=$2 folder=$3
shift 3
mkdir -p "$folder/corpus"
cp "$seeds"/* "$folder/corpus"
status=0
# Without stacks of allocations, a tenth of the time; what breaks it is run again with them.
ASAN_OPTIONS=malloc_context_size=0 "$fuzzer" -close_fd_mask=3 -print_final_stats=1 \
  -timeout=10 -rss_limit_mb=4096 -max_len=20000 \
  -artifact_prefix="$folder/broken-" "$@" "$folder/corpus" >"$folder/log" 2>&1 || status=$?
if ((status)); then
  tail -n 3 "$folder/log"
  # A fuzzer ends with 77 at what it finds, which would say of a test that it was skipped.
  for input in "$folder"/broken-*; do
    [[ -e $input ]] || continue
    said=$("$fuzzer" -timeout=10 "$input" 2>&1 | grep -vE '^INFO|Running') || true
    head -n 20 <<<"$said"
    echo "FAILED: ${fuzzer##*/fuzz_}: ${input##*/}: $(head -n 1 <<<"$said")"
  done
  exit 1
fi
awk -v name="${fuzzer##*/fuzz_}" '/stat::number_of_executed_units/ { runs = $2 } / cov: / { coverage = $4 }
  END { printf "%s: %d inputs, %d edges of the code, 0 findings\n", name, runs, coverage }' "$folder/log"
