#!/usr/bin/env bash
# page_format.sh ROOT FORMATTER: the pages' scripts and styles, and the tests' scripts, are formatted by prettier, at
# the width of .editorconfig. FORMATTER: where it is installed by page_format/package-lock.json.
set -euo pipefail
cd "${1:?usage: page_format.sh ROOT FORMATTER}"
prettier=${2:?usage: page_format.sh ROOT FORMATTER}/node_modules/prettier/bin/prettier.cjs
if ! command -v node >/dev/null || [[ ! -e $prettier ]]; then
  echo "skipped: prettier is not installed; npm was missing or offline when the build was configured"
  exit 77
fi
mapfile -t files < <(find host_tools tests -name '*.js' -o -name '*.mjs' -o -name '*.css')
((${#files[@]} > 0)) || { echo "no scripts and styles in host_tools and tests" >&2; exit 1; }
node "$prettier" --check "${files[@]}"
