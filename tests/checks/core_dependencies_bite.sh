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
echo "every kind of trespass is refused, and nothing else"
