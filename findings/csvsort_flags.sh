#!/usr/bin/env bash
# Package:  Debian 12 csvkit 1.0.7-1: csvsort.
# Expected: sorting changes the order of the rows, not what is in them.
# Seen:     a column of nothing but 0 and 1 comes out as False and True. With a single 2 in it the numbers stay.
#           --no-inference keeps them, but sorts as text: 100 before 20.
# Matters:  a flag "valid" is text after the sort, and so is a set point of 0 and 1 °/s. The next reader refuses or
#           skips the column, and only in those recordings where no other value occurs.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian csvkit=1.0.7-1
sorted() { csvsort -c time "$@" run.csv | tail -n +2 | xargs; }
printf '%s\n' time,valid 20,1 100,0 >run.csv
stated '20,True 100,False
20,1 100,0 300,2
100,0 20,1' "$(sorted; echo 300,2 >>run.csv; sorted; sed -i '$d' run.csv; sorted --no-inference)"
