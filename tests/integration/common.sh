# Sourced by the tests of this folder.

# fail TEXT: ends the test.
fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# enter_scratch: goes to a folder of the test's own, $scratch, which is removed at its end.
enter_scratch() {
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  cd "$scratch"
}

# value FILE KEY...: a member of a JSON file.
value() {
  local file=$1
  shift
  printf 'file(READ "%s" text)\nstring(JSON value GET "${text}" %s)\nmessage("${value}")\n' \
    "$file" "$*" >value.cmake
  cmake -P value.cmake 2>&1
}

# awk with normal(), a draw of a standard normal distribution, beside what the program defines.
awk_normal() {
  local arguments=("$@")
  local program=$((${#arguments[@]} - 1))
  arguments[program]="function normal() { return sqrt(-2 * log(1 - rand())) * cos(6.283185307 * rand()) }
${arguments[program]}"
  awk "${arguments[@]}"
}
