#!/usr/bin/env bash
# sentences_bite.sh: the check of sentences refuses 26 words, wherever they stand in prose, and takes 25.
set -euo pipefail
here=$(realpath "$(dirname "$0")")
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir "$tree/docs" "$tree/firmware"

# words N: a sentence of N words without its stop.
words() { printf 'Word %.0s' $(seq "$1") | sed 's/ $//'; }
judge() { printf '# Page\n\n%b\n' "$1" >"$tree/docs/page.md" && "$here/sentences.sh" "$tree" >"$tree/said" 2>&1; }

for right in "$(words 25)." "$(words 20). $(words 20)." "$(words 20)! (\`$(words 20)\`) $(words 5)." "* $(words 25)" \
  "* $(words 20)\n* $(words 20)" "| $(words 40) |" "    $(words 40)" "\`\`\`\n$(words 40)\n\`\`\`" "# $(words 40)" \
  "$(words 12)\n$(words 13)." "[$(words 25)](a.md)" "$(words 24) \`a\nb c\` word."; do
  judge "$right" || { echo "refused: $right: $(cat "$tree/said")" >&2; exit 1; }
done
for wrong in "$(words 26)." "$(words 26)" "$(words 13)\n$(words 13)." "* $(words 13)\n  $(words 13)" "1. $(words 26)" \
  "$(words 5). $(words 13); $(words 13)." "$(words 13), e.g. $(words 13)." "[$(words 26)](a.md)" "![$(words 26)](a.png)" \
  "| a |\n\n$(words 26)" "\`\`\`\na\n\`\`\`\n$(words 26)" "$(words 20) (a b. c) $(words 5)."; do
  ! judge "$wrong" || { echo "accepted: $wrong" >&2; exit 1; }
  grep -q 'docs/page.md:[3-9]: 2[6-9] words' "$tree/said" || { echo "no place: $wrong: $(cat "$tree/said")" >&2; exit 1; }
done
judge 'right' && words 26 >"$tree/firmware/page.md"
"$here/sentences.sh" "$tree" | grep -q '1 pages elsewhere' || { echo "a page elsewhere is not named" >&2; exit 1; }
echo "long sentences are found in paragraphs, lists, links and pictures"
