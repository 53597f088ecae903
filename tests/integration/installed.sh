#!/usr/bin/env bash
# installed.sh BUILD SOURCE: what `cmake --install` leaves is enough to work with, the source tree forgotten: the
# tool runs, its manual and completion are where Debian looks for them, and firmware of one's own, built with
# find_package(fogcomp) for the board's processor, sends what the tool predicts. The same as a Debian package.
set -euo pipefail
source "$(dirname "$0")/common.sh"
build=$(realpath "${1:?usage: installed.sh BUILD SOURCE}") source=$(realpath "$2")
here=$(realpath "$(dirname "$0")")
enter_scratch

cmake --install "$build" --prefix prefix >installed.txt
PATH=$PWD/prefix/bin:$PATH
[[ $(command -v fogcomp) == "$PWD/prefix/bin/fogcomp" ]] || fail "another fogcomp: $(command -v fogcomp)"
cmp <(fogcomp man) prefix/share/man/man1/fogcomp.1
cmp <(fogcomp completion bash) prefix/share/bash-completion/completions/fogcomp
! grep -rqF "$source" prefix/share || fail "the source tree's path is installed"

fogcomp simulate -o run.csv --profile static >said.txt
fogcomp fit run.csv -o gyro.model --effects bias >said.txt
fogcomp export gyro.model -o fog_model.h --sample-rate 0.1 >said.txt

# The package: contents, dependencies that a machine without a compiler has, and the program out of it runs.
if command -v dpkg-shlibdeps >/dev/null; then
  (cd "$build" && cpack -B "$scratch/package" >"$scratch/cpack.txt" 2>&1) || { cat cpack.txt; exit 1; }
  mapfile -t packages < <(find package -maxdepth 1 -name 'fogcomp_*.deb')
  ((${#packages[@]} == 1)) || fail "packages: ${packages[*]}"
  depends=$(dpkg-deb -f "${packages[0]}" Depends)
  [[ $depends == *libc6* && $depends == *libstdc++6* ]] || fail "Depends: $depends"
  [[ ! $depends =~ dev|eigen|npm ]] || fail "Depends: $depends"
  dpkg-deb -x "${packages[0]}" root
  diff <(cd root/usr && find . -type f | sort) <(cd prefix && find . -type f | sort) ||
    fail "the package holds something else"
  root/usr/bin/fogcomp fit run.csv -o packaged.model --effects bias >said.txt
  cmp gyro.model packaged.model
  echo "${packages[0]##*/}: $(stat -c %s "${packages[0]}") bytes, depends on $depends"
else
  echo "(no dpkg-shlibdeps here: the package was not made)"
fi

command -v arm-none-eabi-g++ >/dev/null || { echo "skipped: no arm-none-eabi-g++ here"; exit 77; }
cp -r "$here/installed_core" own
cp "$source"/cmake/toolchains/{arm-none-eabi,bare_metal}.cmake own # any other would do
cmake -S own -B built -G Ninja -DCMAKE_TOOLCHAIN_FILE="$PWD/own/arm-none-eabi.cmake" -DCMAKE_PREFIX_PATH="$PWD/prefix" \
  -DMODEL_FOLDER="$PWD" >configured.txt || { cat configured.txt; exit 1; }
cmake --build built -j 2 >built.txt || { cat built.txt; exit 1; }
command -v qemu-system-arm >/dev/null || { echo "skipped: no qemu-system-arm here"; exit 77; }
fogcomp stream fog_model.h run.csv -o in.bin >said.txt
fogcomp replay fog_model.h run.csv -o expected.bin >said.txt
"$source/tests/target/run_semihosted.sh" mps2-an386 built/own_firmware.elf .
cmp expected.bin out.bin
echo "own firmware, $(arm-none-eabi-size built/own_firmware.elf | awk 'NR == 2 { print $1 }') bytes:" \
  "$(stat -c %s out.bin) bytes of output, as predicted"
