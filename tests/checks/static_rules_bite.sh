#!/usr/bin/env bash
# static_rules_bite.sh ROOT: each tool, and each family of rules, refuses a fault planted in a source or a header; a
# source without one is taken.
set -euo pipefail
root=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
core=$copy/firmware/core
mkdir -p "$core"
cp "$root/firmware/core/.clang-tidy" "$core"

# refuses RULE FILE TEXT
refuses() {
  echo "$3" >"$core/$2"
  local status=0
  "$here/static_rules.sh" "$copy" >"$copy/said" 2>&1 || status=$?
  ((status != 77)) || { cat "$copy/said"; exit 77; }
  ((status != 0)) && grep -q -- "$1" "$copy/said" || { echo "accepted: $3"; cat "$copy/said"; exit 1; }
  rm "$core/$2"
}

refuses cppcoreguidelines-narrowing-conversions fault.cpp 'short f(int x) { short y = 0; y += x; return y; }'
refuses bugprone-integer-division fault.hpp '#pragma once
inline double f(int x) { return x / 2; }'
refuses cert-err34-c fault.cpp '#include <cstdlib>
int f(const char* s) { return std::atoi(s); }'
refuses clang-analyzer-core fault.cpp 'int f(bool b) { int x; if (b) x = 1; return x; }'
refuses arrayIndexOutOfBounds fault.cpp 'int f() { int a[2] = {}; return a[2]; }'

echo 'int f(int x) { return x + 1; }' >"$core/sound.cpp"
"$here/static_rules.sh" "$copy" || { echo "refused: a source without a fault"; exit 1; }
echo "each family of rules refuses its fault, and nothing else"
