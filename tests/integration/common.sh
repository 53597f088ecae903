# Sourced by the tests of this folder, which end at the first command that fails: with its place, the claim and what
# there is instead.
set -E
trap 'echo "FAILED: ${BASH_SOURCE[0]##*/}:$LINENO: $BASH_COMMAND" >&2' ERR

# fail TEXT: ends the test.
fail() {
  echo "FAILED: ${0##*/}:${BASH_LINENO[-2]}: $*" >&2
  exit 1
}

# enter_scratch: goes to a folder of the test's own, $scratch, which is removed at its end.
enter_scratch() {
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  cd "$scratch"
}

# value FILE MEMBER: of a JSON file, as jq names it: .runs[0].rows
value() {
  jq -rc "$2" "$1"
}

# holds FILE CLAIM: CLAIM, an expression of jq, is true of a JSON file. If not, the members that it names are shown.
holds() {
  ! jq -e "$2" "$1" >claim.txt 2>&1 || return 0
  local member seen=
  for member in $(grep -oE '\.[a-z][][a-z_0-9.]*' <<<"$2" | sort -u); do
    seen+="; $member is $(jq -c "$member" "$1" 2>&1 || true)"
  done
  fail "$1: not $2$seen"
}

# in_full: what fogcomp says, each sentence in one line.
in_full() { sed -E ':a;N;$!ba;s/\n    ([^ ])/ \1/g'; }

# says FILE REGEX [WHEN]: a line or sentence of FILE matches.
says() {
  grep -qE -- "$2" "$1" || grep -qE -- "$2" <(in_full <"$1") ||
    fail "${3:+$3: }$1 does not say '$2' but: $(cat "$1")"
}

# same_bytes EXPECTED FILE: the files are equal; else the first byte that differs is named.
same_bytes() {
  local difference
  difference=$(cmp "$1" "$2" 2>&1) || fail "$difference"
}

# share MIN COUNT CLAIM...: CLAIM SEED succeeds for at least MIN of the seeds 1 to COUNT. For what a test claims of
# chance: which seeds they are must not matter.
share() {
  local min=$1 count=$2 seed good=0 without=
  shift 2
  for ((seed = 1; seed <= count; ++seed)); do
    if "$@" "$seed"; then good=$((good + 1)); else without+=" $seed"; fi
  done
  ((good >= min)) || fail "$*: $good of $count draws, not $min; not with the seeds$without"
  echo "$*: $good of $count draws"
}

# awk whose numbers have a point, whatever the language of the machine: mawk's would have that language's comma.
awk() {
  LC_ALL=C command awk "$@"
}

# random_awk ARGUMENTS...: awk with seed_draws(SEED), uniform() in (0, 1) and normal(), of a standard normal
# distribution. rand() differs between mawk and gawk, and even between their releases: recordings would, too. The
# generator is L'Ecuyer's (Efficient and portable combined random number generators, CACM 31, 1988); its products stay
# below 2^53.
random_awk() {
  local arguments=("$@")
  local program=$((${#arguments[@]} - 1))
  arguments[program]='function seed_draws(seed) { draws_a = 1 + seed % 2147483561; draws_b = 1 + seed % 2147483397
    for (draws_i = 0; draws_i < 20; ++draws_i) uniform() }
    function uniform(difference) {
      draws_a = draws_a * 40014 % 2147483563; draws_b = draws_b * 40692 % 2147483399
      difference = draws_a - draws_b
      return (difference < 1 ? difference + 2147483562 : difference) / 2147483563 }
    function normal(radius) { radius = sqrt(-2 * log(uniform())); return radius * cos(6.283185307 * uniform()) }
'"${arguments[program]}"
  awk "${arguments[@]}"
}

# refuses_fit RUN PATTERN WORDS...: `fogcomp fit RUN WORDS...` ends with code 2, one line, no file.
refuses_fit() {
  local run=$1 pattern=$2 status=0
  shift 2
  "$fogcomp" fit "$run" -o refused.model "$@" >refused.out 2>refused.txt || status=$?
  ((status == 2)) || fail "fit $*: exit code $status"
  [[ ! -s refused.out && ! -e refused.model ]] || fail "fit $*: an output"
  (($(wc -l <refused.txt) == 1)) || fail "fit $*: $(cat refused.txt)"
  says refused.txt "$pattern" "fit $*"
}
