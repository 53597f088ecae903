#!/usr/bin/env bash
# own_effect.sh SOURCE BUILD: carries out firmware/core/effects/TUTORIAL.md in a copy of the tree, block by block:
# ```cpp file=PATH is written to PATH, ```sh is run. BUILD holds the libraries of SOURCE.
set -euo pipefail
source=${1:?usage: own_effect.sh SOURCE BUILD} built=${2:?usage: own_effect.sh SOURCE BUILD}
page=$source/firmware/core/effects/TUTORIAL.md
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
cp -r "$source"/{CMakeLists.txt,CMakePresets.json,cmake,firmware,host_tools,linker,tests} "$copy"
cd "$copy"
# Thrown away, so that only compiling it must be fast.
sed -i 's/"Release"/"None"/; 0,/"None"/s//"None", "CMAKE_CXX_COMPILER": "clang++"/' CMakePresets.json
# As in a tree that is built already, only libraries that include the registry are compiled: BUILD has the others.
compiled=$(ninja -C "$built" -t deps | awk '/: #deps/ { object = $1 } /core\/effects\/registry\.hpp$/ { print object }' |
  sed -nE 's|^host_tools/CMakeFiles/(fogcomp_[a-z]+)\.dir/.*|\1|p' | sort -u | paste -sd '|')
[[ $compiled ]] || { echo "no library in $built includes the registry of effects" >&2; exit 1; }
sed -i -E "/^fog_host_library\(($compiled) /! s/^fog_host_library\(/fog_as_built(/; 1 {
i function(fog_as_built name folder)
i add_library(\${name} INTERFACE)
i target_include_directories(\${name} INTERFACE \${CMAKE_CURRENT_SOURCE_DIR})
i target_link_libraries(\${name} INTERFACE $built/host_tools/lib\${name}.a \${ARGN})
i endfunction()
}" host_tools/CMakeLists.txt

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
      clang-format --dry-run --Werror --style="file:$source/.clang-format" "${target#file=}"
      ;;
    sh)
      bash -euo pipefail "$text" >log 2>&1 || { cat log; exit 1; }
      grep -E "temperature_rate_squared|K2|PASSED" log || true
      ;;
    *)
      echo "a block of kind '$language' in $page" >&2
      exit 1
      ;;
  esac
  blocks=$((blocks + 1))
done
[[ -f build/stm32f405/fogcomp.bin ]] || { echo "the page built no image" >&2; exit 1; }
grep -q temperature_rate_squared fog_model.h
echo "$blocks blocks carried out"
