#!/usr/bin/env bash
# core_dependencies_bite.sh ROOT: the scan refuses a core file that reaches outside or computes in floating point, in
# whatever form; and takes comments, strings and integers for what they are.
set -euo pipefail
root=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
mkdir "$copy/host_tools"
cp -r "$root/firmware" "$copy/firmware"
core=$copy/firmware/core

# trespass FOLDER TEXT: another file in that folder of the core, which the next scan has to name.
trespasses=()
trespass() {
  local file=core/$1/trespass_${#trespasses[@]}.hpp
  echo "$2" >"$copy/firmware/$file"
  trespasses+=("$file")
}
# all_are_named: one scan refuses the core and names every one of them.
all_are_named() {
  ! "$here/core_dependencies.sh" "$copy" >/dev/null 2>"$copy/said" || { echo "accepted: ${trespasses[*]}" >&2; exit 1; }
  for file in "${trespasses[@]}"; do
    grep -q "$file" "$copy/said" || { echo "accepted in core: $(cat "$copy/firmware/$file")" >&2; exit 1; }
    rm "$copy/firmware/$file"
  done
  trespasses=()
}
is_accepted() {
  "$here/core_dependencies.sh" "$copy" >/dev/null 2>"$copy/said" || { cat "$copy/said" >&2; exit 1; }
}

for text in '#include "hal/clock.hpp"' '#include <vector>' '#include<cmath>' '#include "fog_model.h"' \
  '#include <vector>  // #include "core/x.hpp"' \
  'double x = 1;' 'double f(double a, double b) { return a * b; }' 'float* f();  // a pointer' '/* one */ double x;' \
  $'/* a\n * b */ long double x = 1;' $'// a\nfloat x;' 'char s[] = "//"; float x;' \
    "char c = '\"'; float y; char d = '\"';" \
  'auto limits = std::numeric_limits<double>::max();' 'Span<const float> values;' 'auto x = 1.0f * n;' 'auto x = 1.;' \
  'auto x = .5 * n;' 'auto x = 1e3;' 'auto x = 0x1p-3;' "auto x = 1'000.5;" '_Float32 x{};' '#define HALF 0.5'; do
  trespass signal "$text"
done
# Upwards in the order of the folders; what would be a circle.
trespass frames '#include "core/health/image_seal.hpp"'
trespass network '#include "core/effects/effect.hpp"'
trespass expression '#include "core/effects/thermal_hysteresis.hpp"'
trespass fixed_point '#include "core/pipeline/compensator.hpp"'
for text in 'int f(int x) { return x >> 3; }' 'int f(int x, int y) { return (x + y) << 2; }' \
  'void f(int& x) { x >>= 1; }' \
  'auto f(unsigned x) { return (x << 3) | (std::uint32_t{1} << 2); }'; do
  trespass denoise "$text"
  trespass network "$text"
done
all_are_named

# What another fault in the same folder would hide; a folder without a place.
trespass signal '#include "core/../hal/clock.hpp"'
all_are_named
mkdir "$core/another"
echo '#include <cstdint>' >"$core/another/new.hpp"
! "$here/core_dependencies.sh" "$copy" >/dev/null 2>"$copy/said" && grep -q another "$copy/said" ||
  { echo "a folder without a place is accepted" >&2; exit 1; }
rm -r "$core/another"

printf '%s\n' '// double, 0.5' $'/* float,\n   1.5e3 */' 'const char* s = "float, 0.5 \" 1e3";' \
  "auto n = 1'000'000 + 0x1e5;" \
  'int double_buffer = a.b5 + x1.e4;' >"$core/signal/harmless.hpp"
echo 'using Pairs = Span<const Pair<int, int>>; constexpr auto kMask = std::uint32_t{1} << 7U;' \
  >"$core/denoise/harmless.hpp"
is_accepted
echo "every kind of trespass is refused, and nothing else"
