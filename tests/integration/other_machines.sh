#!/usr/bin/env bash
# other_machines.sh FOGCOMP SOURCE: tests that make recordings, search shapes and compare printed figures pass on other
# machines, too: with the other awk, in a language with a decimal comma, on one processor, and on a processor without AVX2
# and FMA, where exp and sin of the C library round otherwise.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: other_machines.sh FOGCOMP SOURCE}") source=$(realpath "${2:?}")
here=$(realpath "$(dirname "$0")")
enter_scratch

# on NAME COMMAND...: the tests under COMMAND, which starts another command on such a machine.
on() {
  local name=$1 test words
  shift
  for test in one_temperature_each.sh equal_figures.sh "readme_example.sh $source/README.md"; do
    read -ra words <<<"$test"
    "$@" bash "$here/${words[0]}" "$fogcomp" "${words[@]:1}" >said.txt 2>&1 ||
      fail "$name: ${words[0]}: $(grep ^FAILED said.txt || tail -n 5 said.txt)"
  done
  echo "$name: passed"
}

# What can be had of them, two at once.
machine=(taskset -c "$(taskset -cp $$ | sed 's/.*: *//; s/[,-].*//')") name="one processor"
for awk in mawk gawk; do
  if ! type -P $awk >/dev/null; then
    echo "$awk: not here"
  elif [[ ! $(type -P $awk) -ef $(type -P awk) ]]; then
    mkdir $awk
    ln -s "$(command -v $awk)" $awk/awk
    machine+=(env PATH="$PWD/$awk:$PATH") name+=", $awk"
  fi
done
on "$name" "${machine[@]}"

machine=() name=
mkdir locales
if localedef -i de_DE -f UTF-8 locales/de_DE.UTF-8 >said.txt 2>&1; then
  machine+=(LOCPATH="$PWD/locales" LC_ALL=de_DE.UTF-8) name="decimal comma"
  [[ $(env "${machine[@]}" locale decimal_point) == , ]] || fail "no decimal comma in $(env "${machine[@]}" locale)"
else
  echo "decimal comma: $(head -n 1 said.txt)"
fi
if grep -qw avx2 /proc/cpuinfo; then
  machine+=(GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX512F) name+="${name:+, }without AVX2"
else
  echo "without AVX2: this processor"
fi
((${#machine[@]} == 0)) || on "$name" env "${machine[@]}"
