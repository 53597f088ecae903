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
