# Sourced by host_tools/quickstart.sh, tests/run.sh and tests/bench/run.sh: which Debian packages the project needs, and
# how they get there.

# What builds the tool and the firmware and boots the images.
build_packages=(
  g++ cmake ninja-build libeigen3-dev
  gcc-arm-none-eabi binutils-arm-none-eabi libstdc++-arm-none-eabi-dev
  qemu-system-arm
)
# The plots of reports come from npm, whoever has installed it.
command -v npm >/dev/null || build_packages+=(npm)
# What tests/run.sh needs beside that.
quick_packages=(libgtest-dev ccache jq)
# What tests/run.sh --all needs besides: the second line builds sanitized, the third compiles and runs the core for
# another instruction set, the fourth is told how to flash a board, the fifth looks at package and manual, the sixth
# makes the page that calculates, the seventh is another awk and another language, the eighth reads the core, the last
# runs the gyros of a lot.
test_packages=(
  clang-format chromium
  clang libclang-rt-dev
  gcc-riscv64-unknown-elf qemu-system-misc
  openocd stlink-tools dfu-util
  dpkg-dev man-db
  emscripten zopfli
  gawk locales
  clang-tidy cppcheck gappa
  parallel
)

# What tests/bench/run.sh needs beside the first.
bench_packages=(libbenchmark-dev python3-pywt)

# require_packages NAME...: installs what is missing, as root or by sudo; where neither is to be had,
# says what to ask for and returns 2.
require_packages() {
  local missing=() name
  for name in "$@"; do
    dpkg-query -W -f='${Status}' "$name" 2>/dev/null | grep -q "install ok installed" ||
      missing+=("$name")
  done
  ((${#missing[@]} == 0)) && return 0

  local as_root=()
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null || ! sudo -v 2>/dev/null; then
      echo "These packages are missing, and only root may install them. Ask for:" >&2
      echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
      return 2
    fi
    as_root=(sudo)
  fi
  echo "installing ${missing[*]}"
  "${as_root[@]}" apt-get -o DPkg::Lock::Timeout=600 update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -o DPkg::Lock::Timeout=600 install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}
