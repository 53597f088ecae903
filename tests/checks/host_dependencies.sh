#!/usr/bin/env bash
# host_dependencies.sh ROOT: data goes down the folders of host_tools and nothing reaches back up: each includes the
# core, hal and the folders before it in this list, and no other. Its names are in the namespace of its name
# (support's in fogcomp itself), and no function has the name of one of support.
set -euo pipefail
cd "${1:?usage: host_dependencies.sh ROOT}/host_tools"
status=0
order=(support recording simulation model network denoise series noise runs judge compare fit planning diagnosis board research batch \
  workflow findings report cli workbench)
known=
for folder in "${order[@]}"; do
  known+="${known:+|}$folder"
  own=fogcomp::$folder
  [[ $folder == support ]] && own=fogcomp
  if found=$(grep -rnE '^namespace fogcomp' "$folder" | grep -vE ":namespace $own(::rules)? \{"); then
    echo "host_tools/$folder opens another namespace than $own:" >&2
    echo "$found" >&2
    status=1
  fi
  if found=$(grep -rnE '^\s*#\s*include "' "$folder" | grep -vE "#\s*include \"(core|hal|$known)/"); then
    echo "host_tools/$folder includes what comes after it:" >&2
    echo "$found" >&2
    status=1
  fi
done
# In a unity build a function of a folder hides one of fogcomp itself from all files of the folder.
functions='^[A-Za-z][A-Za-z0-9_:<>&, ]* [*&]?'
names=$(grep -hoE "${functions}[a-z_0-9]+\(" support/*.hpp | grep -oE '[a-z_0-9]+\($' | tr -d '(' | paste -sd '|')
if found=$(grep -rnE --include='*.[ch]pp' "$functions($names)\(" "${order[@]:1}"); then
  echo "a function has the name of one of support, which it hides:" >&2
  echo "$found" >&2
  status=1
fi
for folder in */; do
  [[ " ${order[*]} " == *" ${folder%/} "* ]] || { echo "host_tools/$folder has no place in the order" >&2; status=1; }
done
((status == 0)) && echo "${#order[@]} folders keep their order and their namespaces"
exit "$status"
