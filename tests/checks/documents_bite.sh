#!/usr/bin/env bash
# documents_bite.sh: the check of the documents refuses a link, a heading, the name of a file, a command, an option, a test
# and a line that are wrong, and takes right ones.
set -euo pipefail
here=$(realpath "$(dirname "$0")")
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir -p "$tree/part" "$tree/tests/unit" "$tree/tests/checks"
printf '# Part\n\n## `add`: one, or several\n' >"$tree/part/README.md"

echo 'constexpr int kOne = 1;' >"$tree/part/one.cpp"
printf '#!/bin/sh\ncase $1 in --fast) ;; esac\n' >"$tree/tests/try.sh" && chmod +x "$tree/tests/try.sh"
printf '#!/bin/sh\n' >"$tree/tests/data.sh"
echo 'fog_gtest(test_part unit/part unit fogcomp_part)' >"$tree/tests/CMakeLists.txt"
printf 'TEST(Part, Works) {}\nTEST_P(\n    PartOf, AlsoWorks) {}\n' >"$tree/tests/unit/part_test.cpp"
echo 'fit: --levels --rate' >"$tree/tests/checks/command_options.txt"
echo '{ "configurePresets": [{ "name": "host" }] }' >"$tree/CMakePresets.json"

# judge TEXT...: the check's opinion of a page of these, a paragraph each; of the i-th, the line where it begins: at[i].
judge() {
  printf '# Page\n' >"$tree/README.md"
  at=()
  for text in "$@"; do
    at+=($(($(wc -l <"$tree/README.md") + 2)))
    printf '\n%b\n' "$text" >>"$tree/README.md"
  done
  "$here/documents.sh" "$tree" >"$tree/said" 2>&1
}
long=$(printf 'a%.0s' {1..121})
judge '[a](part/README.md)' '[a\nb](part/README.md#add-one-or-several)' '[a](#page)' '[a](https://x.org/none)' \
  "| $long |" '`[a](none.md)`' '```\n[a](none.md)\n```' '[`a`](part/)' \
  '`part/one.cpp`' '`one.cpp`' '`part/one`' '`part/`' '`boards/NAME/wiring.hpp`' '`run.csv`' '`deg/h`' '`tests/try.sh -o x`' \
  '`part/README.md`' '`fogcomp fit --levels 3 --rate 9`' '`fit --rate`' '`--levels`' '    $ fogcomp fit --help' \
  '`git log --oneline`' '`kOne`' '`tests/try.sh --fast`' '`--fast`' '(`fogcomp\nfit --levels 3`)' 'a `fogcomp` fot' \
  '`Part.Works` `PartOf.AlsoWorks`, `Part.*`' '| promise | test | figure |\n|---|---|---|\n| it works | `Part.Works` | 3 |' \
  '| promise | test |\n|---|---|\n| it works | `tests/try.sh` |' '`EFFECT.PARAMETER`' \
  '    ctest --test-dir build -L unit' '`cmake --preset host`' '    cmake --build build --target test_part' ||
  { echo "refused what is right: $(cat "$tree/said")" >&2; exit 1; }
wrong=('[a](none.md)' '[a](part/README.md#none)' '[a](#none)' '[a\nb](part/none.md)' '| [`a`](none.md) |'
  "$long"
  "\`\`\`\n$long\n\`\`\`" '`part/two.cpp`' '`two.hpp`' '`part/two`' '`none.md`' '`tests/data.sh`'
  '    ctest --test-dir build -R unit' '`ctest -L none`' '`cmake --preset none`' '    cmake --build b --target none'
  '`part/data.txt`' '`kTwo`' '`fogcomp fot`' '    $ fogcomp fot run.csv' '`cat x | fogcomp fot -`' '`fogcomp fit --lovels 3`'
  '`Part.Fails`' '`Other.*`' '| promise | test |\n| it works | `part/one.cpp` |'
  '`fit --lovels`' '`--lovels`' '    $ fogcomp fit --lovels' '`tests/try.sh --slow`' '(`fogcomp\nfit --lovels 3`)')
! judge "${wrong[@]}" || { echo "accepted what is wrong" >&2; exit 1; }
for i in "${!wrong[@]}"; do
  lines=$(grep -c . < <(printf '%b\n' "${wrong[i]}"))
  awk -F: -v first="${at[i]}" -v lines="$lines" \
    '$1 == "README.md" && $2 >= first && $2 < first + lines { found = 1 } END { exit !found }' "$tree/said" ||
    { echo "accepted: ${wrong[i]}" >&2; exit 1; }
done
judge 'right' && printf '// See part/two.hpp.\n' >"$tree/part/one.cpp"
! judge 'right' || { echo "accepted: a comment that names no file" >&2; exit 1; }
echo "broken links, headings, names of files, commands and long lines are found"
