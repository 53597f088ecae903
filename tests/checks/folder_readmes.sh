#!/usr/bin/env bash
# folder_readmes.sh ROOT: each folder of the core and of the host tool, and platform/, says in at most 40 lines what
# it takes, what it gives, where to begin and what it must not know; and the links in it lead somewhere.
set -euo pipefail
cd "${1:?usage: folder_readmes.sh ROOT}"
status=0
complain() { echo "$1" >&2; status=1; }
for folder in firmware/core/*/ firmware/platform/ host_tools/*/; do
  page=${folder}README.md
  [[ -f $page ]] || { complain "$page is missing"; continue; }
  (($(wc -l <"$page") <= 40)) || complain "$page has more than 40 lines"
  for words in '**Takes**' '**Gives**' '**Begin with**' '**Must not know**'; do
    grep -qF "$words" "$page" || complain "$page: no $words"
  done
  # Links, and files named as code that lie in the folder itself.
  while read -r target; do
    [[ -e $folder$target ]] || complain "$page names $target, which is not there"
  done < <(grep -oE '\]\([A-Za-z_./]+\)|`[a-z_0-9]+\.[ch]pp`' "$page" | tr -d '`()]')
done
exit "$status"
