#!/usr/bin/env bash
# function_length.sh ROOT: no function of the firmware and the host tool has more than 40 lines between its braces,
# lambdas included. Read off the layout that check.format holds: what stands in a block is indented further
# than the line that the block closes on.
set -euo pipefail
cd "${1:?usage: function_length.sh ROOT}"
# The interpreter's one switch: a line or two for each operation, no step of which is one by itself.
allowed='firmware/core/expression/expression_bank.hpp run'

find firmware host_tools -name '*.hpp' -o -name '*.cpp' -o -name '*.c' | LC_ALL=C sort |
  xargs awk -v allowed="$allowed" '
  FNR == 1 { head = ""; inside = 0 }
  inside {
    if (substr($0, 1, indent + 1) != blanks "}") next
    inside = 0
    ++functions
    judge(FNR - opened - 1)
    next
  }
  /^[ \t]*(\/\/|#|$)/ || /^ *(public|private|protected):/ { next }
  {
    if (head == "") {
      first = FNR
      indent = match($0, /[^ ]/) - 1
      blanks = substr($0, 1, indent)
    }
    sub(/ *\/\/.*/, "")
    head = head " " $0
  }
  /\{$/ {
    if (head ~ /^ *(template ?<.*> *)?(inline )?(namespace|class|struct|enum|union|extern)/ &&
        head !~ /\) (const |override |noexcept )*\{$/) {
      head = ""
    } else if (head ~ /\(.*[)}]( const| override| noexcept| final)*( ->[^{}=]*)? \{$/) {
      inside = 1
      opened = FNR
      name = head
      sub(/\(.*/, "", name)
      sub(/.*[ *&~]/, "", name)
      head = ""
    }
    next
  }
  /[;}]$/ { head = "" }
  function judge(lines) {
    if (lines <= 40 || FILENAME " " name == allowed) return
    printf "%s:%d: %s has %d lines, 40 are enough\n", FILENAME, first, name, lines > "/dev/stderr"
    ++long
  }
  END {
    if (functions < 100) { print "too few functions found: " functions > "/dev/stderr"; exit 1 }
    if (long) exit 1
    print functions " functions of several lines, none longer than 40"
  }'
