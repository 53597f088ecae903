# shellcheck shell=bash
# Sourced by the findings: a temporary folder, pinned packages, and the verdict.

# enter_scratch: goes to a folder of the finding's own, which is removed at its end.
enter_scratch() {
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  cd "$scratch" || exit
}

# npm_packages NAME@VERSION...: installs them in the scratch folder; no install scripts are run.
npm_packages() {
  echo '{"private": true}' >package.json
  npm install --silent --save-exact --ignore-scripts --no-audit --no-fund "$@" >npm.log 2>&1 ||
    { echo "cannot install $*" >&2; exit 2; }
}

# debian NAME=VERSION...: installs what is missing (as root), then checks the versions.
debian() {
  local package missing=()
  for package in "$@"; do installed "$package" || missing+=("$package"); done
  if ((${#missing[@]})); then
    DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 install -y --no-install-recommends \
      "${missing[@]}" >apt.log 2>&1 || true
  fi
  for package in "$@"; do
    installed "$package" || { echo "needs the Debian 12 package $package" >&2; exit 2; }
  done
}

installed() {
  [[ $(dpkg-query -W -f='${db:Status-Status} ${Version}' "${1%%=*}" 2>/dev/null) == "installed ${1#*=}" ]]
}

# stated EXPECTED SEEN: prints what was seen; ends with 1 where it is not what the finding states.
stated() {
  printf '%s\n' "$2"
  if [[ $1 != "$2" ]]; then
    printf 'CHANGED: stated was\n%s\n' "$1"
    exit 1
  fi
}
