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
file=$copy/firmware/core/signal/span.hpp
cp "$file" "$copy/original"

# accepts TEXT: whether the scan passes with the text at the end of a core file.
accepts() {
  { cat "$copy/original"; echo "$1"; } >"$file"
  "$here/core_dependencies.sh" "$copy" >/dev/null 2>&1
}

for text in '#include "hal/clock.hpp"' '#include <vector>' '#include<cmath>' '#include "fog_model.h"' \
  '#include <vector>  // #include "core/x.hpp"' '#include "core/../hal/clock.hpp"' \
  'double x = 1;' 'double f(double a, double b) { return a * b; }' 'float* f();  // a pointer' '/* one */ double x;' \
  $'/* a\n * b */ long double x = 1;' $'// a\nfloat x;' 'char s[] = "//"; float x;' "char c = '\"'; float y; char d = '\"';" \
  'auto limits = std::numeric_limits<double>::max();' 'Span<const float> values;' 'auto x = 1.0f * n;' 'auto x = 1.;' \
  'auto x = .5 * n;' 'auto x = 1e3;' 'auto x = 0x1p-3;' "auto x = 1'000.5;" '_Float32 x{};' '#define HALF 0.5'; do
  ! accepts "$text" || { echo "accepted in core: $text" >&2; exit 1; }
done
harmless=('// double, 0.5' $'/* float,\n   1.5e3 */' 'const char* s = "float, 0.5 \" 1e3";' "auto n = 1'000'000 + 0x1e5;"
  'int double_buffer = a.b5 + x1.e4;')
accepts "$(printf '%s\n' "${harmless[@]}")" || { echo "refused in core: one of ${harmless[*]}" >&2; exit 1; }
cp "$copy/original" "$file"

# refuses FILE TEXT: whether the scan does, with the text at the end of a file of its own.
refuses() {
  echo "$2" >"$copy/firmware/core/$1"
  ! "$here/core_dependencies.sh" "$copy" >/dev/null 2>&1 || { echo "accepted in core/$1: $2" >&2; exit 1; }
  rm "$copy/firmware/core/$1"
}
# Upwards in the order of the folders; what would be a circle; a folder without a place.
refuses frames/new.hpp '#include "core/health/image_seal.hpp"'
refuses network/new.hpp '#include "core/effects/effect.hpp"'
refuses expression/new.hpp '#include "core/effects/thermal_hysteresis.hpp"'
refuses fixed_point/new.hpp '#include "core/pipeline/compensator.hpp"'
mkdir "$copy/firmware/core/another"
refuses another/new.hpp '#include <cstdint>'
rmdir "$copy/firmware/core/another"
for text in 'int f(int x) { return x >> 3; }' 'int f(int x, int y) { return (x + y) << 2; }' 'void f(int& x) { x >>= 1; }' \
  'auto f(unsigned x) { return (x << 3) | (std::uint32_t{1} << 2); }'; do
  refuses denoise/new.hpp "$text"
  refuses network/new.cpp "$text"
done
echo 'using Pairs = Span<const Pair<int, int>>; constexpr auto kMask = std::uint32_t{1} << 7U;' >"$copy/firmware/core/denoise/new.hpp"
"$here/core_dependencies.sh" "$copy" >/dev/null
echo "every kind of trespass is refused, and nothing else"
