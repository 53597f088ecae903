#!/usr/bin/env bash
# foreign_matrix.sh FOGCOMP: what Octave, R, NumPy, pandas, gnuplot and LibreOffice write of one recording
# (foreign_matrix/), each property of a file alone and with each other one, is read as it is or refused in one line.
# Programs that are missing are named; skipped where all are.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: foreign_matrix.sh FOGCOMP}")
writers=$(realpath "$(dirname "$0")")/foreign_matrix
PATH=/usr/bin:$PATH # Debian's Python, which has Debian's NumPy
enter_scratch
missing=() files=0

# written_by NAME COMMAND...: in a folder of its own.
written_by() {
  local name=$1
  shift
  mkdir "$name"
  (cd "$name" && "$@") >said.txt 2>&1 || fail "$name: $(cat said.txt)"
}

# judge NAME MIN: of the files of one program none is wrong; at least MIN are read.
judge() {
  local file right=0 refused=0 status
  for file in "$1"/*.csv; do
    status=0
    "$fogcomp" convert "$file" -o out.csv >said.txt 2>remarks.txt || status=$?
    case $status in
    0)
      awk -F, 'function far(a, b, e) { return a - b > e || b - a > e }
        NR == 1 { next }
        NR == 2 { begin = $1 }
        { i = NR - 2; rate = 7.25 + 0.5 * (7 * i % 11) }
        far($1 - begin, 0.5 * i, 1e-4) || far($2, 21.5 + 0.125 * i, 1e-3) || far($3, rate, 1e-4) { print; exit wrong = 1 }
        END { exit wrong || NR != 41 }' out.csv >wrong.txt ||
        fail "$file is read wrongly: $(cat remarks.txt wrong.txt; head -n 3 "$file")"
      right=$((right + 1)) ;;
    2)
      [[ $(tail -n 1 remarks.txt) == *"$file"* || $(tail -n 1 remarks.txt) == --columns* ]] ||
        fail "$file: $(cat remarks.txt)"
      refused=$((refused + 1)) ;;
    *) fail "$file: exit code $status: $(cat remarks.txt)" ;;
    esac
  done
  echo "$1: $right read, $refused refused"
  ((right >= $2)) || fail "$1: $right files are read, not $2"
  files=$((files + right + refused))
}

if command -v octave-cli >/dev/null; then
  written_by octave octave-cli "$writers/write.m"
  judge octave 60
else
  missing+=(octave)
fi
if command -v Rscript >/dev/null; then
  written_by R Rscript "$writers/write.R"
  judge R 50
else
  missing+=(r-base-core)
fi
for package in numpy pandas; do
  if python3 -c "import $package" 2>/dev/null; then
    written_by "$package" python3 "$writers/write_$package.py"
    judge "$package" 50
  else
    missing+=("python3-$package")
  fi
done
if command -v gnuplot >/dev/null; then
  written_by gnuplot gnuplot "$writers/write.gnuplot"
  judge gnuplot 12
else
  missing+=(gnuplot)
fi
if command -v soffice >/dev/null; then
  written_by libreoffice "$writers/write_libreoffice.sh"
  judge libreoffice 24
else
  missing+=(libreoffice-calc-nogui)
fi
echo "$files files"
((${#missing[@]} == 0)) || echo "not tried, not installed: ${missing[*]}"
((files > 0)) || exit 77
