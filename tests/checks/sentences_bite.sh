#!/usr/bin/env bash
# sentences_bite.sh: the check of sentences refuses 26 words, wherever they stand in prose, and takes 25.
set -euo pipefail
here=$(realpath "$(dirname "$0")")
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir "$tree/docs" "$tree/elsewhere"

# words N: a sentence of N words without its stop.
words() { printf 'Word %.0s' $(seq "$1") | sed 's/ $//'; }

right=("$(words 25)." "$(words 20). $(words 20)." "$(words 20)! (\`$(words 20)\`) $(words 5)." "* $(words 25)"
  "* $(words 20)\n* $(words 20)" "| $(words 40) |" "    $(words 40)" "\`\`\`\n$(words 40)\n\`\`\`" "# $(words 40)"
  "$(words 12)\n$(words 13)." "[$(words 25)](a.md)" "$(words 24) \`a\nb c\` word.")
wrong=("$(words 26)." "$(words 26)" "$(words 13)\n$(words 13)." "* $(words 13)\n  $(words 13)" "1. $(words 26)"
  "$(words 5). $(words 13); $(words 13)." "$(words 13), e.g. $(words 13)." "[$(words 26)](a.md)" "![$(words 26)](a.png)"
  "| a |\n\n$(words 26)" "\`\`\`\na\n\`\`\`\n$(words 26)" "$(words 20) (a b. c) $(words 5).")
# A page for each; on the third line of a page or after it stands what it is about.
for i in "${!right[@]}"; do printf '# Page\n\n%b\n' "${right[i]}" >"$tree/docs/right$i.md"; done
for i in "${!wrong[@]}"; do printf '# Page\n\n%b\n' "${wrong[i]}" >"$tree/docs/wrong$i.md"; done
words 26 >"$tree/elsewhere/page.md"

! "$here/sentences.sh" "$tree" >"$tree/said" 2>&1 || { echo "accepted all" >&2; exit 1; }
! grep right "$tree/said" >&2 || { echo "refused what is right" >&2; exit 1; }
for i in "${!wrong[@]}"; do
  grep -q "^docs/wrong$i.md:[3-9]: 2[6-9] words" "$tree/said" || { echo "accepted: ${wrong[i]}" >&2; exit 1; }
done
grep -q '(1 pages elsewhere' "$tree/said" || { echo "a page elsewhere is not counted" >&2; exit 1; }
rm "$tree"/docs/wrong*.md
"$here/sentences.sh" "$tree" >/dev/null || { echo "refused what is right" >&2; exit 1; }
echo "long sentences are found in paragraphs, lists, links and pictures"
