#!/usr/bin/env bash
# documents_bite.sh: the check of the documents refuses a link, a heading and a line that are wrong, and takes right
# ones.
set -euo pipefail
here=$(realpath "$(dirname "$0")")
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir "$tree/part"
printf '# Part\n\n## `add`: one, or several\n' >"$tree/part/README.md"

# judge TEXT: the check's opinion of a page.
judge() { printf '%b\n' "# Page\n\n$1" >"$tree/README.md" && "$here/documents.sh" "$tree" >"$tree/said" 2>&1; }
long=$(printf 'a%.0s' {1..121})
for right in '[a](part/README.md)' '[a\nb](part/README.md#add-one-or-several)' '[a](#page)' '[a](https://x.org/none)' \
  "| $long |" '`[a](none.md)`' '```\n[a](none.md)\n```' '[`a`](part/)'; do
  judge "$right" || { echo "refused: $right: $(cat "$tree/said")" >&2; exit 1; }
done
for wrong in '[a](none.md)' '[a](part/README.md#none)' '[a](#none)' '[a\nb](part/none.md)' '| [`a`](none.md) |' \
  "$long" \
  "\`\`\`\n$long\n\`\`\`"; do
  ! judge "$wrong" || { echo "accepted: $wrong" >&2; exit 1; }
done
echo "broken links, headings and long lines are found"
