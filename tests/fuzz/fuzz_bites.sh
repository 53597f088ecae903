#!/usr/bin/env bash
# fuzz_bites.sh: what a fuzzer finds fails its test and is named. The fuzzer here is a script that ends as libFuzzer
# does, with 77, which of a test would mean that it was skipped.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
fuzz=$(realpath "$(dirname "$0")/fuzz.sh")
enter_scratch
mkdir seeds
echo seed >seeds/seed
cat >fuzz_script <<'SCRIPT'
#!/usr/bin/env bash
for word in "$@"; do [[ $word != -artifact_prefix=* ]] || echo 7 >"${word#*=}crash-1"; done
echo "broken: it answers requests" >&2
exit 77
SCRIPT
chmod +x fuzz_script
status=0
"$fuzz" ./fuzz_script seeds found >said.txt 2>&1 || status=$?
((status == 1)) || fail "a finding ends with $status: $(cat said.txt)"
says said.txt '^FAILED: script: broken-crash-1: broken: it answers requests$'
