#!/usr/bin/env bash
# outputs_are_safe.sh FOGCOMP: an output appears completely or not at all, only at the given path: full disks, limits,
# signals, links, permissions, prepared temporary names. Failures are reported with exit code 2.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: outputs_are_safe.sh FOGCOMP}")
scratch=$(mktemp -d)
trap 'chmod -R u+w "$scratch"; rm -rf "$scratch"' EXIT
cd "$scratch"
"$fogcomp" simulate -o run.csv >said.txt
"$fogcomp" fit run.csv -o gyro.model --effects bias,temperature_rate >said.txt
no_parts() { [[ -z $(find . -name '*.part-*') ]] || fail "left behind after $1: $(find . -name '*.part-*')"; }
# refused REGEX COMMAND...: exit code 2 and one line.
refused() {
  local expected=$1 status=0
  shift
  "$@" 2>errors.txt || status=$?
  ((status == 2)) || fail "exit code $status: $* $(cat errors.txt)"
  [[ $(wc -l <errors.txt) == 1 ]] && grep -qE -- "$expected" errors.txt || fail "$* -> $(cat errors.txt)"
  no_parts "$*"
}

# Standard output that cannot be written, for any command.
mkdir -p lot/G1 && cp run.csv lot/G1
for words in "effects" "effects --json" "effects --markdown" man "completion bash" "--help" "--version" "help fit" \
  "info run.csv" "info run.csv --json" "simulate --list" "simulate -o s.csv" "simulate -o s.csv --json" \
  "fit run.csv -o f.model --effects bias" "fit run.csv -o f.model --effects bias --json" \
  "compare gyro.model run.csv --details" "compare gyro.model run.csv --json" "diagnose gyro.model run.csv --json" \
  "add gyro.model bias_temperature run.csv -o a.model" "history gyro.model" "history gyro.model --json" \
  "denoise run.csv -o d.csv --json" "export gyro.model -o g.h --json" "replay gyro.model run.csv -o o.bin --json" \
  "apply gyro.model run.csv -o c.csv" "convert run.csv -o p.csv --json" "stream gyro.model run.csv -o i.bin" \
    "batch lot -o results --effects bias --json"; do
  # shellcheck disable=SC2086
  refused '^standard output: cannot be written' "$fogcomp" $words >/dev/full
done
rm -r lot results

# A limit on a file's size acts as a full disk: a message, the old files untouched, no half ones.
echo kept >kept
for words in "simulate -o kept" "simulate -o kept --hide truth.csv" "denoise run.csv -o kept" \
  "apply gyro.model run.csv -o kept" "convert run.csv -o kept" \
  "fit run.csv -o kept --effects bias --report page.html" "info run.csv --report page.html" \
  "add gyro.model bias_temperature run.csv -o kept --report page.html"; do
  # shellcheck disable=SC2086
  refused '^(kept|truth.csv|page.html): cannot be written \(File too large\)' bash -c "ulimit -f 8; exec \"\$@\"" \
    - "$fogcomp" $words
  [[ $(cat kept) == kept && ! -e page.html && ! -e truth.csv ]] || fail "written beyond the limit: $words"
done

# A board's table, bytes that are no text, is no recording: it is exported again.
for _ in first again; do
  "$fogcomp" export gyro.model -o board.bin --format table --serial FOG-1 >/dev/null || fail "a table is not exported again"
done

# Every signal that ends the program leaves the old file and no half one. Where files without a name can be had, so does
# SIGKILL; where they cannot (without /proc), a temporary file is removed.
# is_writing: whether the tool has an output open, with a temporary name or without one.
is_writing() {
  [[ -n $(find . -name 'kept.part-*') ]] || find "/proc/$tool/fd" -lname "$PWD/*(deleted)" 2>/dev/null | grep -q .
}
# ended_by SIGNAL WORDS...: the tool, started by these words, is ended while it writes.
ended_by() {
  local signal=$1
  shift
  "$@" env --default-signal "$fogcomp" simulate -o kept --rate 1000 >said.txt 2>&1 &
  tool=$!
  until is_writing; do
    kill -0 "$tool" || fail "ended before SIG$signal: $(cat said.txt)"
    sleep 0.01
  done
  named=$(find . -name 'kept.part-*')
  kill -"$signal" "$tool"
  ! wait "$tool" 2>/dev/null || fail "SIG$signal does not end it"
  [[ $(cat kept) == kept ]] || fail "SIG$signal: the old file is gone"
}
signals=(INT TERM HUP QUIT PIPE ALRM XCPU USR1 USR2 ABRT SEGV BUS)
for signal in "${signals[@]}"; do
  ended_by "$signal"
  no_parts "SIG$signal"
done
ended_by KILL
if [[ -z $named ]]; then
  no_parts SIGKILL
else
  case $(stat -f -c %T .) in
    ext2/ext3 | xfs | btrfs | tmpfs) fail "a temporary name where the file system needs none: $named" ;;
  esac
  echo "no file without a name in $PWD: SIGKILL not tested"
  rm kept.part-*
fi
# shellcheck disable=SC2016
without_proc=(unshare --user --map-root-user --mount bash -c 'mount -t tmpfs none /proc && exec "$@"' -)
if "${without_proc[@]}" true 2>/dev/null; then
  for signal in "${signals[@]}"; do
    ended_by "$signal" "${without_proc[@]}"
    [[ -n $named ]] || fail "a file without a name, and no /proc to name it"
    no_parts "SIG$signal without /proc"
  done
  "${without_proc[@]}" "$fogcomp" simulate -o unnamed >said.txt
  cmp run.csv unnamed
else
  echo "no /proc can be hidden here: named temporary files not tested"
fi

# A link stays one, and what it names is replaced, with its permissions; where it leads nowhere, a file is made there.
mkdir -p there
echo old >there/target
chmod 640 there/target
ln -s there/target link
ln -s there/new dangling
ln -s link chain
for name in link chain; do
  echo old >there/target
  "$fogcomp" simulate -o "$name" >said.txt
  [[ -L $name ]] && cmp run.csv there/target || fail "$name is not written through"
  [[ $(stat -c %a there/target) == 640 ]] || fail "the permissions are $(stat -c %a there/target)"
done
"$fogcomp" simulate -o dangling >said.txt
[[ -L dangling ]] && cmp run.csv there/new || fail "a dangling link is not written through"
ln -s circle circle
refused '^circle: is a link that leads to itself' "$fogcomp" simulate -o circle

# Nobody can prepare the temporary name: not of one process, and no name is opened through a link.
echo victim >victim
# shellcheck disable=SC2016
bash -c 'for i in $(seq $(($$ - 2)) $(($$ + 2))); do ln -s victim "planted.csv.part-$i"; done
  exec "$1" simulate -o planted.csv' - "$fogcomp" >said.txt
[[ $(cat victim) == victim && ! -L planted.csv ]] && cmp run.csv planted.csv || fail "written through a planted link"
rm planted.csv*

# A file that is read-only stays, even if root asks.
echo kept >read_only
chmod 444 read_only
refused '^read_only: is read-only; name another file' "$fogcomp" simulate -o read_only
refused '^read_only: is read-only; name another file' "$fogcomp" info run.csv --report read_only
[[ $(cat read_only) == kept ]] || fail "a read-only file is replaced"

# Standard output as a file: bytes go where the shell said, and nothing takes its place.
"$fogcomp" simulate -o /dev/stdout >stdout.csv
head -n "$(wc -l <run.csv)" stdout.csv | cmp run.csv -
[[ $(tail -n 1 stdout.csv) == /dev/stdout:* && -L /dev/stdout ]] || fail "$(tail -n 1 stdout.csv)"
"$fogcomp" simulate -o /dev/stdout | cat >piped.csv
cmp stdout.csv piped.csv

# Devices that never end are no recordings, models or profiles, whoever opens them.
for device in /dev/zero /dev/urandom /dev/full; do
  for words in "info $device" "fit $device -o kept --effects bias" "compare gyro.model $device" \
    "compare $device run.csv" \
    "replay gyro.model $device -o kept" "simulate -o kept --profile $device"; do
    # shellcheck disable=SC2086
    refused "^$device: is a device that never ends" timeout 20 "$fogcomp" $words
  done
done
refused '^/dev/stdin: is a device that never ends' timeout 20 "$fogcomp" info /dev/stdin </dev/zero
refused 'no good frame' timeout 60 "$fogcomp" info /dev/stdin < <(cat /dev/zero)
refused '64 MiB' timeout 60 "$fogcomp" compare /dev/stdin run.csv < <(cat /dev/zero)
echo "outputs are whole, where they belong, or not there"
