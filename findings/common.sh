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

# newlib_on_board: Debian 12's newlib for a Cortex-M, and the board in QEMU that on_board runs a program on.
newlib_on_board() {
  debian libnewlib-arm-none-eabi=3.3.0-1.3+deb12u1 gcc-arm-none-eabi=15:12.2.rel1-1 \
    qemu-system-arm=1:7.2+dfsg-7+deb12u18+b3
  cat >vectors.c <<'C'
void _start(void);
__attribute__((section(".vectors"), used)) void *const vectors[] = {(void *)0x20080000, _start};
C
}

# on_board OPTION...: compiles probe.c with these options and runs it; prints what it prints.
on_board() {
  arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -O1 "$@" --specs=rdimon.specs -Wl,--section-start=.vectors=0 \
    vectors.c probe.c -lm -o probe.elf
  timeout 60 qemu-system-arm -M mps2-an386 -nographic -semihosting -kernel probe.elf 2>&1
}

# stated EXPECTED SEEN: prints what was seen; ends with 1 where it is not what the finding states.
stated() {
  printf '%s\n' "$2"
  if [[ $1 != "$2" ]]; then
    printf 'CHANGED: stated was\n%s\n' "$1"
    exit 1
  fi
}
