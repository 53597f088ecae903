# Sourced by the tests that run a board in the background: a folder of its own in $scratch; at the end, however it
# comes, what runs is stopped and the folder removed.
scratch=$(mktemp -d)
clean_up() {
  jobs -p | xargs -r kill 2>/dev/null || true
  wait
  rm -rf "$scratch"
}
trap clean_up EXIT
trap 'exit 143' TERM INT HUP

# wait_for COMMAND...: until it succeeds, $patience_s at the most; else shows the board's console and what it has sent.
patience_s=60
wait_for() {
  local deadline=$((SECONDS + patience_s))
  until "$@"; do
    if ((SECONDS >= deadline)); then
      echo "gave up waiting for: $*" >&2
      cat "$scratch/console" >&2
      [[ ! -e $scratch/sent ]] || od -c "$scratch/sent" | tail >&2
      exit 1
    fi
    sleep 0.02
  done
}
booted() { grep -q '^image: ' "$scratch/console"; }
