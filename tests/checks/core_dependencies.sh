#!/usr/bin/env bash
# core_dependencies.sh ROOT: who may include whom (firmware/DESIGN.md, "One drift model"), by include scan:
# core only core and the freestanding part of the standard library; hal nothing of ours; platform hal,
# the CRC, the size of the output frames, what a serial line is and the thermometers; the generated header only app and tests. Within the
# core a folder includes those before it in a list. And no floating point in core; in denoise and network no shift
# but those that fixed_point names.
set -euo pipefail
root=${1:?usage: core_dependencies.sh ROOT}
cd "$root/firmware"
status=0
sources=(--include='*.[chS]' --include='*.[ch]pp')

# forbid FOLDER ALLOWED_REGEX: every include in FOLDER must match.
forbid() {
  local folder=$1 allowed=$2 found
  [[ -d $folder ]] || { echo "no folder $folder" >&2; exit 1; }
  if found=$(grep -rnE "${sources[@]}" "^\s*#\s*include" "$folder" |
    grep -vE "^[^:]+:[0-9]+:\s*#\s*include ($allowed)" ||
    grep -rnE "${sources[@]}" "^\s*#\s*include.*\.\./" "$folder"); then
    echo "$folder includes what it may not:" >&2
    echo "$found" >&2
    status=1
  fi
}

standard='<(array|cstddef|cstdint|initializer_list|limits|new|tuple|type_traits|utility)>'
own='("fog_own_effects.hpp"|FOG_OWN_EFFECTS)' # a user's header of effects
forbid core "\"core/|$own|$standard"
forbid hal "$standard"
forbid platform "\"(core/bytes/crc.hpp|core/frames/(output_bytes|serial_line).hpp|core/thermometer/|hal/|platform/|wiring.hpp\")|$standard"
forbid app "\"(app|core|hal|platform)/|\"(fog_model|build_identity)\.h\"|$standard"

# The folders of the core, each of which may know those before it and no other: so there is no circle.
order=(fixed_point bytes signal thermal frames health acquisition thermometer network expression effects compensation
  denoise pipeline)
known=
for folder in "${order[@]}"; do
  known+="${known:+|}$folder"
  forbid "core/$folder" "\"core/($known)/|$own|<"
done
for folder in core/*/; do
  [[ " ${order[*]} " == *" $(basename "$folder") "* ]] || { echo "$folder has no place in the order" >&2; status=1; }
done

# No type and no number of the core is a floating-point one. Looked for in a copy without comments, strings and
# character constants: where several could begin, the first does.
bare=$(mktemp -d)
trap 'rm -rf "$bare"' EXIT
cp -r core "$bare"
find "$bare" -type f -regex '.*\.\([ch]pp\|[chS]\)' -exec \
  sed -i -zE "s@//[^\n]*|/\*([^*]|\*+[^*/])*\*+/|\"(\\\\.|[^\"\\\\])*\"|'(\\\\[^']+|[^'\\\\])'@ @g" {} +
type='\b(float|double|_Float[0-9]+x?|__fp16|__float[0-9]+)\b'
decimal="[0-9][0-9']*\.|\.[0-9]|[0-9][0-9']*[eE][-+]?[0-9]"
hexadecimal="0[xX][0-9a-fA-F'.]+[pP][-+]?[0-9]"
if found=$(cd "$bare" && grep -rnE "${sources[@]}" "$type|(^|[^A-Za-z0-9_.'])($decimal|$hexadecimal)" core); then
  echo "floating point in core:" >&2
  echo "$found" >&2
  status=1
fi

# A 1 may become a mask. clang-format puts spaces around a shift, not around the ends of templates.
if found=$(cd "$bare" && grep -rnE "${sources[@]}" '(<<|>>)' core/denoise core/network |
  sed -E 's/\{1\} <</{1} MASK/g' | grep -E '\s(<<|>>)=?(\s|$)'); then
  echo "a shift that core/fixed_point does not name:" >&2
  echo "$found" >&2
  status=1
fi

if found=$(grep -rlE "${sources[@]}" '#\s*include.*fog_model\.h' core hal platform ../host_tools); then
  echo "includes the generated header and may not: $found" >&2
  status=1
fi
if found=$(grep -rnE "${sources[@]}" '#\s*include "platform/' ../host_tools); then
  echo "host_tools includes a platform: $found" >&2
  status=1
fi
((status == 0)) && echo "$(grep -rlE '#\s*include' core | wc -l) files of core keep the rule"
exit "$status"
