#!/usr/bin/env bash
# without_engine.sh FOGCOMP ROOT: a build that is to have the engine is refused where em++ is missing; FOGCOMP, built
# without the engine, says what is missing, writes nothing for `workbench`, and reports without one.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
fogcomp=$(realpath "${1:?usage: without_engine.sh FOGCOMP ROOT}")
root=$(realpath "${2:?usage: without_engine.sh FOGCOMP ROOT}")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

# As configured with no em++ on the path.
cat >configure.cmake <<SCRIPT
include("$root/cmake/modules/FogWorkbenchEngine.cmake")
fog_workbench_engine()
SCRIPT
cmake -DFOG_EMSCRIPTEN=FALSE -P configure.cmake >said.txt 2>&1 || fail "does not configure: $(cat said.txt)"
! cmake -DFOG_EMSCRIPTEN=FALSE -DFOG_WORKBENCH=ON -P configure.cmake >said.txt 2>&1 || fail "configures without em++"
grep -q "FOG_WORKBENCH needs emscripten" said.txt || fail "refused with: $(cat said.txt)"

cp "$root/docs/examples/mems_chamber.csv" run.csv
code=0
"$fogcomp" workbench run.csv -o bench.html 2>said.txt || code=$?
((code == 2)) || fail "exit code $code"
grep -q '^workbench: this fogcomp was built without its engine for pages: host_tools/quickstart.sh --page builds it' said.txt ||
  fail "$(cat said.txt)"
(($(wc -l <said.txt) == 1)) || fail "more than a line: $(cat said.txt)"
[[ ! -e bench.html ]] || fail "writes a page all the same"
"$fogcomp" fit run.csv -o run.model --effects bias --report report.html >/dev/null 2>&1
grep -q '<main id="report">' report.html || fail "no report"
! grep -q -e 'id="workbench"' -e 'wasm-unsafe-eval' -e data-file= report.html || fail "a report has a workbench"
