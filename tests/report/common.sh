# Sourced by the tests of this folder, which look at the pages that $fogcomp writes.
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
source "$here/../integration/common.sh"

# needs PROGRAM...: skips the test where one of them, or a file of that name, is missing.
needs() {
  local program
  for program; do
    command -v "$program" >/dev/null || [[ -e $program ]] || { echo "skipped: no $program here"; exit 77; }
  done
}

# needs_engine: skips the test where $fogcomp has no engine for pages; else leaves a page without recordings, empty.html.
needs_engine() {
  ! "$fogcomp" workbench -o empty.html >said.txt 2>&1 || return 0
  grep -q "built without" said.txt || { cat said.txt >&2; exit 1; }
  echo "skipped: $(cat said.txt)"
  exit 77
}
