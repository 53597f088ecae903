#!/usr/bin/env bash
# stack_depth.sh IMAGE.elf OBJECTS PERCENT: the deepest the stack of a Cortex-M image can become: the longest chain of
# calls from the reset handler, every interrupt upon another, a fault upon that. Frames are what the compiler states
# (OBJECTS/**/*.ci, -fcallgraph-info=su), or of a library's function those that its instructions show; calls are those
# in the image's own code, one through a pointer going to any function of which the image holds the address. Exits 1 for
# recursion, a frame of unknown size, or where less than PERCENT of the stack's reserve stays free.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
(($# == 3)) || { sed -n '2,6s/^# //p' "$0" >&2; exit 2; }
elf=$1 objects=$2 percent=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# NAME BYTES KIND of every function that was compiled.
find "$objects" -name '*.ci' -exec cat {} + |
  sed -nE 's/^node: \{ title: "([^"]*:)?([^":]+)" label: ".*\\n([0-9]+) bytes \(([a-z,]+)\).*/\2 \3 \4/p' |
  sort -u >"$scratch/frames"
arm-none-eabi-nm -t d "$elf" | awk '$2 ~ /[tTwW]/ { print $1, $3 }' >"$scratch/functions"
reserve=$((0x$(arm-none-eabi-objdump -h "$elf" | awk '$2 == ".stack" { print $3 }')))
arm-none-eabi-objcopy -O binary -j .text -j .data "$elf" "$scratch/bytes"
od -An -v -t u4 -w4 "$scratch/bytes" >"$scratch/words"
vectors=$((0x$(arm-none-eabi-nm -S "$elf" | awk '/kVectors/ { print $2 }') / 4))
arm-none-eabi-objdump -d --no-show-raw-insn "$elf" >"$scratch/code"

awk -v reserve="$reserve" -v percent="$percent" -v vectors="$vectors" -v image="${elf##*/}" '
  function fail(text) { print "FAILED: " image ": " text > "/dev/stderr"; failed = 1; exit 1 }
  # Deepest below and with function f; path[f] is the next one on the way.
  function depth(f,    n, i, callee, below, max) {
    if (f in known) return known[f]
    if (f in open) fail("recursion through " f)
    open[f] = 1
    max = 0
    n = split(calls[f], list, " ")
    for (i = 1; i <= n; i++) targets[f, i] = list[i]
    for (i = 1; i <= n; i++) {
      callee = targets[f, i]
      below = depth(callee)
      if (below > max) { max = below; path[f] = callee }
    }
    delete open[f]
    if (!(f in frame)) frame[f] = shown[f] + 0
    return known[f] = frame[f] + max
  }
  function chain(f,    text) {
    for (; f != ""; f = path[f]) text = text (text == "" ? "" : " > ") f " " frame[f]
    return text
  }
  FILENAME ~ /frames$/ {
    if ($3 !~ /static/) dynamic[$1] = 1
    if (!($1 in frame) || $2 > frame[$1]) frame[$1] = $2
    next
  }
  FILENAME ~ /functions$/ { name_at[$1 + 0] = $2; next }
  FILENAME ~ /words$/ {
    word = $1 + 0
    name = name_at[word - 1]
    if (word % 2 == 1 && name != "") {
      if (FNR > vectors) taken[name] = 1
      else if (FNR == 2) main_at = name
      else if (FNR <= 8) is_fault[name] = 1
      else is_interrupt[name]++
    }
    next
  }
  /^[0-9a-f]+ <.*>:$/ { at = substr($2, 2, length($2) - 3); if (at !~ /^\$/) now = at; code[now] = 1; next }
  $2 ~ /^(bl|b|b\.w|b\.n|b[a-z][a-z](\.[wn])?|cbn?z)$/ && $NF ~ /^<[^+]*>$/ {
    callee = substr($NF, 2, length($NF) - 2)
    if (callee != now) calls[now] = calls[now] " " callee
  }
  $2 == "blx" { indirect[now] = 1 }
  $2 ~ /^push/ || ($2 ~ /^stmdb/ && $3 == "sp!,") {
    text = $0; sub(/^[^{]*\{/, "", text); sub(/\}.*/, "", text); n = split(text, registers, ",")
    for (i = 1; i <= n; i++) shown[now] += 4 * (registers[i] ~ /-/ ? 2 : 1)
  }
  $2 ~ /^sub/ && $3 == "sp," && match($0, /#[0-9]+/) { shown[now] += substr($0, RSTART + 1, RLENGTH - 1) }
  END {
    if (failed) exit 1
    for (f in code) if (f in dynamic) fail("the frame of " f " has no fixed size")
    for (f in indirect) for (t in taken) {
      if (t != f && t in code && !(t in is_fault) && !(t in is_interrupt)) calls[f] = calls[f] " " t
    }
    exception = 36 # eight registers, and a word to align them
    if (main_at == "") fail("no reset handler found")
    main = depth(main_at)
    for (f in is_fault) if ((d = depth(f)) > fault || fault_at == "") { fault = d; fault_at = f }
    # An unused interrupt goes where faults go: upon it comes no other. The others may have any priorities.
    for (f in is_interrupt) if (!(f in is_fault)) {
      interrupts += is_interrupt[f] * (depth(f) + exception)
      nested = nested (nested == "" ? "" : " | ") chain(f)
    }
    total = main + interrupts + fault + exception * (fault_at != "")
    printf "%s: %d bytes of a reserve of %d, %.0f %% free\n", image, total, reserve, 100 * (1 - total / reserve)
    printf "  running   %5d: %s\n", main, chain(main_at)
    printf "  interrupts %4d: %s\n", interrupts, nested
    printf "  fault     %5d: %s\n", fault + exception, chain(fault_at)
    if (total > reserve * (1 - percent / 100)) fail("less than " percent " % of the stack stays free: " total " of " reserve " bytes are taken")
  }' "$scratch/frames" "$scratch/functions" "$scratch/words" "$scratch/code" | arm-none-eabi-c++filt || exit 1
