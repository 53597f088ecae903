#!/usr/bin/env bash
# function_length_bite.sh ROOT: a function of 41 lines is refused, whatever kind it is; one of 40, and what is no
# function, is not.
set -euo pipefail
root=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
cp -r "$root/host_tools" "$root/firmware" "$copy"
file=$copy/host_tools/support/trespass.cpp

# body INDENT LINES: so many statements, a lambda and a loop among them.
body() {
  local i
  printf "%$1s%s\n" "" "const auto f = [](int x) {" "" "  return x;" "" "};" "" "for (;;) {" "" "}" | sed 's/ *$//'
  for ((i = 5; i < $2; ++i)); do printf "%$1s%s\n" "" "++n;"; done
}
# function INDENT LINES DECLARATION...
function_of() {
  local indent=$1 lines=$2
  shift 2
  printf "%${indent}s%s\n" "" "$@"
  body $((indent + 2)) "$lines"
  printf "%${indent}s}\n" ""
}
free() { echo "namespace fogcomp {"; function_of 0 "$1" "int free() {"; echo "}  // namespace fogcomp"; }
member() { echo "class A {"; echo " public:"; function_of 2 "$1" "int member() const override {"; echo "};"; }
constructor() { echo "class A {"; function_of 2 "$1" "A(int x)" "    : x_(x)," "      y_{1} {"; echo " int x_;"; \
  echo "};"; }
template() { function_of 0 "$1" "template <class R>" "auto two_lines(int a," "               const R& r) -> R {"; }
after_table() { printf "%s\n" "constexpr Row kRows[] = {" "  {f(1)," "   2}};"; \
  function_of 0 "$1" "void after_table() {"; }

for kind in free member constructor template after_table; do
  $kind 41 >"$file"
  ! "$here/function_length.sh" "$copy" >/dev/null 2>"$copy/said" && grep -q "trespass.*has 41 lines" "$copy/said" ||
    { echo "accepted: 41 lines of" >&2; cat "$file" "$copy/said" >&2; exit 1; }
  $kind 40 >"$file"
  "$here/function_length.sh" "$copy" >/dev/null || { echo "refused: 40 lines of $kind" >&2; exit 1; }
done

{
  echo "constexpr Row kRows[] = {"
  for ((i = 0; i < 60; ++i)); do echo "    {f($i), 2},"; done
  echo "};"
  echo "struct Large {"
  for ((i = 0; i < 60; ++i)); do echo "  int f$i() { return $i; }"; done
  echo "};"
} >"$file"
"$here/function_length.sh" "$copy" >/dev/null || { echo "a table or a class is taken for a function" >&2; exit 1; }
echo "functions of 41 lines are refused, and nothing else"
