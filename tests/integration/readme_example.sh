#!/usr/bin/env bash
# readme_example.sh FOGCOMP DOCUMENT: a document's examples are what the tool does: its commands are run, and print what
# stands below them. A command goes on after a backslash. `...` stands for any number of lines, ` ...` at the end of a
# line for the rest of it; numbers may differ by 2 % or two units of their last digit, because processors round
# differently.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: readme_example.sh FOGCOMP DOCUMENT}") document=$(realpath "$2")
enter_scratch
mkdir bin
ln -s "$fogcomp" bin/fogcomp
PATH=$PWD/bin:$PATH
docs=$(dirname "$document")/docs # the README's own recordings
[[ ! -d $docs ]] || ln -s "$docs" docs

awk '/^```console/ { inside = 1; next } /^```/ { inside = 0 } inside' "$document" >example
grep -c '^\$ ' example >commands.txt || fail "no example in $document"

# same EXPECTED ACTUAL: as files.
same() {
  awk '
    function number(word) { return word ~ /^[-+]?[0-9]+(\.[0-9]+)?$/ }
    function close_to(a, b, digits, unit, difference) {
      digits = index(a, ".") ? length(a) - index(a, ".") : 0
      unit = 10 ^ -digits
      difference = a - b
      if (difference < 0) difference = -difference
      return difference <= 2.001 * unit || difference <= 0.02 * (a < 0 ? -a : a)
    }
    # Bars of a character are as long as their number.
    function like(a, b, i, n, m, one, other) {
      gsub(/#+/, "#", a); gsub(/#+/, "#", b)
      gsub(/[(),;:%]/, " & ", a); gsub(/[(),;:%]/, " & ", b)
      n = split(a, one, " "); m = split(b, other, " ")
      if (n > 1 && one[n] == "..." && m >= n) m = --n
      if (n != m) return 0
      for (i = 1; i <= n; ++i) {
        if (one[i] == other[i]) continue
        if (!number(one[i]) || !number(other[i]) || !close_to(one[i], other[i])) return 0
      }
      return 1
    }
    NR == FNR { expected[++count] = $0; next }
    { actual[++lines] = $0 }
    END {
      at = 1; open = 0
      for (i = 1; i <= count; ++i) {
        if (expected[i] == "...") { open = 1; continue }
        while (open && at <= lines && !like(expected[i], actual[at])) ++at
        if (at > lines || !like(expected[i], actual[at])) {
          print "expected: " expected[i]; print "there is: " actual[at]; exit 1
        }
        ++at; open = 0
      }
      if (!open && at <= lines) { print "not expected: " actual[at]; exit 1 }
    }' "$1" "$2"
}

# The comparison itself bites.
printf 'a 0.0543\n...\nend\n' >expected
printf 'a 0.0544\nb\nend\n' >actual
same expected actual || fail "two units of the last digit"
printf 'a 0.0543 ...\n' >begins
printf 'a 0.0543 and b\n' >actual
same begins actual || fail "the rest of a line"
printf 'a 0.0643 and b\n' >actual
! same begins actual >said.txt || fail "a line that begins otherwise"
for wrong in 'a 0.0643\nb\nend' 'b 0.0543\nend' 'a 0.0543\nb' 'a 0.0543\nend\nb'; do
  # shellcheck disable=SC2059
  printf "$wrong\n" >actual
  ! same expected actual >said.txt || fail "accepted: $wrong"
done

number=0
goes_on=0
while IFS= read -r line; do
  if ((goes_on)); then
    printf '%s\n' "$line" >>"command$number"
    [[ $line == *\\ ]] || goes_on=0
  elif [[ $line == '$ '* ]]; then
    ((++number))
    printf '%s\n' "${line#\$ }" >"command$number"
    : >"expected$number"
    [[ $line != *\\ ]] || goes_on=1
  else
    printf '%s\n' "$line" >>"expected$number"
  fi
done <example
for ((i = 1; i <= number; ++i)); do
  # 1, the answer is no, only where a refusal stands below the command.
  status=0
  bash -euo pipefail "command$i" >"actual$i" || status=$?
  wanted=0
  ! grep -q '^refused: ' "expected$i" || wanted=1
  ((status == wanted)) || fail "exit code $status: $(cat "command$i")"
  same "expected$i" "actual$i" || fail "$(basename "$document"): $(cat "command$i")"
done
echo "$number commands of $(basename "$document") print what it says"
