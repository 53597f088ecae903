#!/usr/bin/env bash
# foreign_lines.sh FOGCOMP: the line that a refused file of Octave, NumPy or R gets makes a CSV of it, with all digits
# that the program prints. Skipped where none of the programs is installed.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: foreign_lines.sh FOGCOMP}")
PATH=/usr/bin:$PATH # Debian's Python, which has Debian's NumPy
enter_scratch
tried=() missing=()

# makes_csv PROGRAM FILE OPTION...: of what PROGRAM wrote: times 0 to 99, 20 + time / 7, sin(time). fogcomp reads it.
makes_csv() {
  local program=$1 file=$2 line
  shift 2
  ! "$fogcomp" info "$file" 2>said.txt || fail "$program: $file is read"
  line=$(sed -n 's/.*; make a CSV of it: //p' said.txt)
  [[ $line == "$program "* ]] || fail "$program: $(cat said.txt)"
  rm -f run.csv
  eval "${line//FILE/$file}" >printed.txt 2>&1 || fail "$line: $(cat printed.txt)"
  grep -v '"' run.csv | awk -F, '
    function far(a, b) { return a - b > 1e-13 || b - a > 1e-13 }
    far($1, NR - 1) || far($2, 20 + (NR - 1) / 7) || far($3, sin(NR - 1)) { print; exit bad = 1 }
    END { exit bad || NR != 100 }' || fail "$program: the values differ"
  "$fogcomp" convert run.csv -o plain.csv "$@" >said.txt 2>&1 || fail "$program: $(cat said.txt)"
  says said.txt '^plain\.csv: 100 samples' "$program"
  tried+=("$program: $file")
}
columns=(--columns 'time=1[s],temperature=2[degC],rate=3[deg/h]')

if command -v octave >/dev/null; then
  octave --eval "time = 0:99; temperature = 20 + time / 7; rate = sin(time);
    save -v7 v7.mat time temperature rate; save -v6 v6.mat time temperature rate" >/dev/null
  makes_csv octave v7.mat "${columns[@]}"
  makes_csv octave v6.mat "${columns[@]}"
else
  missing+=(octave)
fi
if python3 -c 'import numpy' 2>/dev/null; then
  python3 -c "import numpy as n; t = n.arange(100.0); n.save('run.npy', n.c_[t, 20 + t / 7, n.sin(t)])"
  makes_csv python3 run.npy "${columns[@]}"
else
  missing+=(python3-numpy)
fi
if command -v Rscript >/dev/null; then
  Rscript -e "t <- 0:99; d <- data.frame(time_s = t, temperature_degc = 20 + t / 7, rate_dph = sin(t))
    save(d, file = 'run.rda', compress = FALSE); save(d, file = 'old.rda', compress = FALSE, version = 2)"
  makes_csv Rscript run.rda
  makes_csv Rscript old.rda
else
  missing+=(r-base-core)
fi
printf '%s\n' "${tried[@]}"
((${#missing[@]} == 0)) || echo "not tried, not installed: ${missing[*]}"
((${#tried[@]} > 0)) || exit 77
