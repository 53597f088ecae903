#!/usr/bin/env bash
# own_effect.sh SOURCE BUILD: carries out firmware/core/effects/TUTORIAL.md, block by block: ```cpp file=PATH is written to
# PATH, ```sh is run. This happens in a folder of links to the sources, so that it writes nothing there. It is in BUILD,
# and as deep in it as BUILD in SOURCE: a compiler cache that knows the tree by relative paths (tests/run.sh) has all
# objects that do not depend on the effects.
set -euo pipefail
source "$(dirname "$0")/common.sh"
source=${1:?usage: own_effect.sh SOURCE BUILD} build=${2:?usage: own_effect.sh SOURCE BUILD}
page=$source/firmware/core/effects/TUTORIAL.md
here=$build/own_effect
rm -rf "$here"
mkdir -p "$here"/my_gyro
trap 'rm -rf "$here"' EXIT
ln -s "$source"/{CMakeLists.txt,CMakePresets.json,cmake,firmware,host_tools,linker,tests} "$here"
cd "$here"
export CCACHE_BASEDIR=$source
# What npm has installed for BUILD.
for folder in host_tools/report_library tests/checks/page_format tests/report/browser_driver; do
  [[ -d $build/$folder ]] || continue
  mkdir -p "build/my_gyro/$(dirname "$folder")"
  ln -s "$build/$folder" "build/my_gyro/$folder"
done

# Blocks become numbered files, with their first line's words beside them.
awk '/^```/ { if (inside) { inside = 0; next } inside = 1; n++; print substr($0, 4) > ("block" n ".kind"); next }
     inside { print > ("block" n ".text") }' "$page"
blocks=0
for kind in $(ls block*.kind | sort -V); do
  read -r language target <"$kind"
  text=${kind%.kind}.text
  case $language in
    cpp)
      cp "$text" "${target#file=}"
      [[ $target == *.inc ]] || clang-format --dry-run --Werror --style="file:$source/.clang-format" "${target#file=}"
      ;;
    sh)
      bash -euo pipefail "$text" >log 2>&1 || fail "$(cat "$text"): $(tail -n 20 log)"
      grep -E "temperature_rate_squared|K2|PASSED" log || true
      ;;
    *)
      fail "a block of kind '$language' in $page"
      ;;
  esac
  blocks=$((blocks + 1))
done
[[ -f build/my_board/fogcomp.bin ]] || fail "the page built no image"
says fog_model.h temperature_rate_squared
echo "$blocks blocks carried out"
