#!/usr/bin/env bash
# diagnosis_cost.sh [FOGCOMP...]: what a diagnosis of a day costs each of these builds of the tool, in rows of 10 s (6,000
# of them) and of 1 s (60,000): instructions in millions, and relative to the first tool. Valgrind counts them, because
# times depend on what else a computer does; it takes minutes a tool for the first rows, and ten times that for the second.
set -euo pipefail
cd "$(dirname "$0")/../.."
source cmake/bootstrap/packages.sh
require_packages valgrind || exit 2
((${#} > 0)) || set -- build/host/fogcomp
tools=()
for tool in "$@"; do tools+=("$(realpath "$tool")"); done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

"${tools[0]}" simulate -o day.csv --rate 1 --seed 3 >/dev/null
for row_s in 10 1; do
  "${tools[0]}" fit day.csv -o day.model --average $row_s --effects bias,bias_temperature:order=3 >/dev/null
  first=
  for tool in "${tools[@]}"; do
    valgrind --tool=cachegrind --cache-sim=no --cachegrind-out-file=/dev/null --log-file=said.txt \
      "$tool" diagnose day.model day.csv --average $row_s >/dev/null
    millions=$(awk '/I +refs:/ { gsub(",", "", $NF); printf "%.0f", $NF / 1e6 }' said.txt)
    first=${first:-$millions}
    awk -v s=$row_s -v m="$millions" -v first="$first" -v tool="$tool" \
      'BEGIN { printf "rows of %2d s: %7d million, ratio %.3f  %s\n", s, m, m / first, tool }'
  done
done
