#!/usr/bin/env bash
# core_dependencies.sh ROOT: who may include whom (firmware/DESIGN.md, "Dependencies"), by include scan:
# core only core and the freestanding part of the standard library; hal nothing of ours; platform hal,
# the CRC and the thermometers; the generated header only app and tests.
set -euo pipefail
root=${1:?usage: core_dependencies.sh ROOT}
cd "$root/firmware"
status=0

# forbid FOLDER ALLOWED_REGEX: every include in FOLDER must match.
forbid() {
  local folder=$1 allowed=$2 found
  [[ -d $folder ]] || { echo "no folder $folder" >&2; exit 1; }
  if found=$(grep -rnE --include="*.?pp" "^\s*#\s*include" "$folder" | grep -vE "#\s*include ($allowed)"); then
    echo "$folder includes what it may not:" >&2
    echo "$found" >&2
    status=1
  fi
}

standard='<(array|cstddef|cstdint|initializer_list|limits|new|tuple|type_traits|utility)>'
forbid core "\"core/|$standard"
forbid hal "$standard"
forbid platform "\"(core/protocol/crc.hpp|core/thermometer/|hal/|platform/)|$standard"
forbid app "\"(app|core|hal|platform)/|\"fog_model.h\"|$standard"

# No type of the core is a floating-point one.
if found=$(grep -rnwE --include="*.?pp" "float|double" core | grep -vE '//|\*'); then
  echo "floating point in core:" >&2
  echo "$found" >&2
  status=1
fi

if found=$(grep -rlE '#\s*include.*fog_model\.h' core hal platform ../host_tools --include='*.?pp'); then
  echo "includes the generated header and may not: $found" >&2
  status=1
fi
if found=$(grep -rnE '#\s*include "platform/' ../host_tools --include='*.?pp'); then
  echo "host_tools includes a platform: $found" >&2
  status=1
fi
((status == 0)) && echo "$(grep -rlE '#\s*include' core | wc -l) files of core keep the rule"
exit "$status"
