#!/usr/bin/env bash
# core_dependencies_bite.sh ROOT: the include scan refuses a core file that reaches outside.
set -euo pipefail
root=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
mkdir "$copy/host_tools"
for line in '#include "hal/clock.hpp"' '#include <vector>' '#include "fog_model.h"' 'double x = 1;'; do
  rm -rf "$copy/firmware"
  cp -r "$root/firmware" "$copy/firmware"
  "$here/core_dependencies.sh" "$copy" >/dev/null
  echo "$line" >>"$copy/firmware/core/signal/span.hpp"
  if "$here/core_dependencies.sh" "$copy" >/dev/null 2>&1; then
    echo "accepted in core: $line" >&2
    exit 1
  fi
done
echo "every kind of trespass is refused"
