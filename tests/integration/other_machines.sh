#!/usr/bin/env bash
# other_machines.sh FOGCOMP SOURCE: tests that make recordings, search shapes and compare printed figures pass on other
# machines, too: with either awk, in a language with a decimal comma, on one processor, and on a processor without AVX2
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

for awk in mawk gawk; do
  if command -v $awk >/dev/null; then
    mkdir $awk
    ln -s "$(command -v $awk)" $awk/awk
    on $awk env PATH="$PWD/$awk:$PATH"
  else
    echo "$awk: not here"
  fi
done

export LOCPATH=$PWD/locales
mkdir locales
if localedef -i de_DE -f UTF-8 locales/de_DE.UTF-8 >said.txt 2>&1; then
  [[ $(LC_ALL=de_DE.UTF-8 locale decimal_point) == , ]] || fail "no decimal comma in $(LC_ALL=de_DE.UTF-8 locale)"
  on "decimal comma" env LC_ALL=de_DE.UTF-8
else
  echo "decimal comma: $(head -n 1 said.txt)"
fi
unset LOCPATH

on "one processor" taskset -c "$(taskset -cp $$ | sed 's/.*: *//; s/[,-].*//')"
if grep -qw avx2 /proc/cpuinfo; then
  on "without AVX2" env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX512F
else
  echo "without AVX2: this processor"
fi
