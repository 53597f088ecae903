#!/usr/bin/env bash
# lag_lemma.sh: gappa proves the lemma by which a first-order lag stays within its inputs, but for 2^-23 + 2^-40
# (interval_numbers.hpp), for every decay, input and state. The board's step is y + s; inputs and states count from the
# largest input so far, or from the least. Then a bound that a step exceeds, by 1 LSB from y = -2^-23 to x = 0, has to
# fail.
set -euo pipefail
command -v gappa >/dev/null || { echo "no gappa: tests/run.sh --all installs it"; exit 77; }

# proves CLAIM: of d, the difference rounded to 22 bits, and of s, the step rounded to 40; halves are rounded up.
proves() {
  timeout 60 gappa 2>/dev/null <<GAPPA
d = fixed<-22, dn>(x - y + 1b-23);
s = fixed<-40, dn>(d * decay + 1b-41);
{ decay in [0, 1] /\\ $1 }
y + s -> y * (1 - decay) + x * decay + (d - (x - y)) * decay + (s - d * decay);
d - (x - y) -> (d - (x - y + 1b-23)) + 1b-23;
s - d * decay -> (s - (d * decay + 1b-41)) + 1b-41;
GAPPA
}

failures=0
while IFS= read -r claim; do
  if proves "$claim"; then echo "proved: $claim"; else echo "FAILED: not proved: $claim"; failures=1; fi
done <<'CLAIMS'
x in [-512, 0] /\ y in [-512, 0] -> y + s <= 131073b-40
x in [0, 512] /\ y in [0, 512] -> y + s >= -131073b-40
x - y in [-512, -1b-40] -> d <= 0
x - y in [1b-40, 512] -> d >= 0
d in [-512, 0] -> s <= 0
d in [0, 512] -> s >= 0
CLAIMS
planted='x in [-512, 0] /\ y in [-512, 0] -> y + s <= 131071b-40'
if proves "$planted"; then echo "FAILED: proves what is not so: $planted"; failures=1; fi
exit "$failures"
