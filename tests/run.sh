#!/usr/bin/env bash
# tests/run.sh [--all | NAME...]: the tests, on Debian 12 from nothing; packages, build and run are one command.
#
# Without arguments what a user needs to trust what he installed. --all: every test there is. NAME is a test, a pattern
# of tests ('target.*') or a kind (unit, golden, ...): only these run, and only what they need is built.
# README.md beside this file lists the kinds.
set -euo pipefail
cd "$(dirname "$0")/.."
source cmake/bootstrap/packages.sh

packages=("${build_packages[@]}" "${quick_packages[@]}")
case ${1:-} in
  --all) packages+=("${test_packages[@]}") ;;
  -*) sed -n '2,6s/^# \?//p' "$0" >&2; exit 2 ;;
esac
require_packages "${packages[@]}" || exit 2

# Tests build images and, with --all, everything a second time under sanitizers.
export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
export CCACHE_DIR=$PWD/build/ccache CCACHE_NOHASHDIR=1
export CCACHE_SLOPPINESS=pch_defines,time_macros

jobs=$(($(nproc) + 1)) # some tests wait, for a browser or for bytes on a line
status=0
results=build/test_results.txt
mkdir -p build
: >"$results"

# tests_of PRESET SELECTION...: the names that CTest selects, and the tests that prepare for them.
tests_of() {
  ctest --test-dir "build/$1" -N "${@:2}" | sed -nE 's/^ *Test +#[0-9]+: ([^ ]+)$/\1/p'
}

# run_tests PRESET SELECTION...: builds what the selected tests need and runs them.
run_tests() {
  local preset=$1 targets
  shift
  targets=$(awk 'NR == FNR { wanted[$1]; next } $1 in wanted { for (i = 3; i <= NF; ++i) print $i }' \
    <(tests_of "$preset" "$@") "build/$preset/tests.txt" | sort -u)
  # shellcheck disable=SC2086
  [[ -z $targets ]] || CCACHE_BASEDIR=$PWD cmake --build "build/$preset" --target $targets || {
    printf '%s\n' "1/1 Test #0: build/$preset ***Failed" "FAILED: it does not compile" >>"$results"
    status=1
    return
  }
  ctest --test-dir "build/$preset" --output-on-failure --no-tests=error -j "$jobs" "$@" | tee -a "$results" ||
    status=1
}

# configure PRESET: quietly, unless it fails.
configure() {
  cmake --preset "$1" >"build/configure_$1.txt" 2>&1 || { cat "build/configure_$1.txt" >&2; exit 1; }
}

# run_named PRESET NAME...: of the names those that the build of PRESET has; the others are in $unknown then.
run_named() {
  local preset=$1 name patterns=()
  shift
  unknown=()
  configure "$preset"
  for name in "$@"; do
    local regex=${name//./[.]}
    regex=${regex//\*/.*}
    mapfile -t names < <(awk -v name="$name" -v regex="^($regex)$" \
      '$1 ~ regex || ("," $2 ",") ~ ("," name ",") { print $1 }' "build/$preset/tests.txt")
    if ((${#names[@]})); then patterns+=("${names[@]//./[.]}"); else unknown+=("$name"); fi
  done
  ((${#patterns[@]} == 0)) || run_tests "$preset" -R "^($(IFS='|'; echo "${patterns[*]}"))\$"
}

case ${1:-} in
  '')
    configure tests
    run_tests tests -L quick
    ;;
  --all)
    configure tests
    run_tests tests
    configure tests_sanitized
    run_tests tests_sanitized
    ;;
  *)
    run_named tests "$@"
    if ((${#unknown[@]})) && command -v clang++ >/dev/null; then
      run_named tests_sanitized "${unknown[@]}"
    fi
    if ((${#unknown[@]})); then
      echo "no test and no kind of test: ${unknown[*]} (tests/README.md lists the kinds; build/tests/tests.txt all tests;" \
        "what needs a browser, emscripten or clang is there once tests/run.sh --all has installed them)" >&2
      exit 2
    fi
    ;;
esac

# The end: what failed, by name and by what it said, then one plain line of counts. Cases of gtest and the scripts' fail()
# say it in a line of their own; of other tests these are the last five lines. known_failures.txt says which are known.
awk '
  reading == "known" {
    if (/^[^#]/) { known[++entries] = $0; found[entries] = 0 }
    next
  }
  /^ *[0-9]+\/[0-9]+ Test / {
    name = $4
    if (/ Passed /) { ++passed; name = "" }
    else if (/\*\*\*Skipped/) { ++skipped; not_run[name]; name = "" }
    else {
      failed[++failures] = name
      if (match($0, /\*\*\*(Timeout|Exception|Not Run)[^ ]*( [A-Z][A-Za-z]+)?/))
        ended[name] = " (" substr($0, RSTART + 3, RLENGTH - 3) ")"
    }
    next
  }
  /^ *Start +[0-9]+: |^[0-9]+% tests passed/ { name = "" }
  name != "" && /[^ ]/ { output[name, ++printed[name]] = $0 }
  name != "" && (/^\[  FAILED  \] [^ ]+[.][^ ]+/ || /^FAILED: /) {
    sub(/^\[  FAILED  \] /, ""); sub(/^FAILED: /, ""); sub(/ \([0-9]+ ms\)$/, "")
    if (!((name, $0) in seen)) said[name] = said[name] $0 "\n"
    seen[name, $0]
  }
  # is_known(TEST, LINE): whether an entry "TEST: BEGINNING" says that the test, or a shard of it, fails with this line.
  function is_known(test, line,   i) {
    sub(/[.][0-9]+$/, "", test)
    sub(/^[a-z_]+[.]sh:[0-9]+: /, "", line)
    for (i = 1; i <= entries; ++i) {
      if (index(test ": " line, known[i]) == 1) return found[i] = 1
    }
    return 0
  }
  function last_lines(test,   i, text) {
    for (i = printed[test] - 4; i <= printed[test]; ++i) if (i > 0) text = text "\n  " output[test, i]
    return text == "" ? "\n  it said nothing" : text
  }
  END {
    for (i = 1; i <= failures; ++i) {
      name = failed[i]
      count = split(said[name], lines, "\n") - 1
      fresh = ""
      for (j = 1; j <= count; ++j) if (!is_known(name, lines[j])) fresh = fresh "\n  " lines[j]
      if (count < 1 && !is_known(name, output[name, printed[name]])) fresh = last_lines(name)
      if (fresh != "") { print "failed: " name ended[name] fresh; ++unexpected }
      else print "known failure: " name
    }
    for (i = 1; all && i <= entries; ++i) {
      test = known[i]
      sub(/:.*/, "", test)
      if (!found[i] && !(test in not_run)) { print "failed: " known[i] "\n  not seen: to leave tests/known_failures.txt"; ++unexpected }
    }
    printf "%d passed, %d failed, %d skipped\n", passed, unexpected, skipped
    exit unexpected > 0 || (failures == 0 && status != 0)
  }' status="$status" all="$([[ ${1:-} == --all ]] && echo 1)" reading=known tests/known_failures.txt reading=results "$results"
