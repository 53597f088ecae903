#!/usr/bin/env bash
# readme_commands.sh ROOT: the first two commands of the README are the quick start and the tests, both
# exist, and CI runs the second and nothing else.
set -euo pipefail
cd "${1:?usage: readme_commands.sh ROOT}"
mapfile -t commands < <(awk '/^```/ { inside = !inside; next } inside && NF { print $1 }' README.md | head -n 2)
[[ ${commands[0]} == host_tools/quickstart.sh && ${commands[1]} == tests/run.sh ]] ||
  { echo "README's first commands: ${commands[*]}" >&2; exit 1; }
for command in "${commands[@]}"; do
  [[ -x $command ]] || { echo "$command cannot be run" >&2; exit 1; }
done
ci=$(grep -vE '^(#|set |cd |$)' .ci/run)
[[ $ci == "exec tests/run.sh" ]] || { echo "CI runs: $ci" >&2; exit 1; }
echo "README and CI name the same commands"
