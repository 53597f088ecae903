#!/usr/bin/env bash
# format.sh ROOT: every C++ file is formatted by clang-format.
set -euo pipefail
cd "${1:?usage: format.sh ROOT}"
find firmware host_tools tests -name '*.hpp' -o -name '*.cpp' |
  xargs clang-format --dry-run --Werror
