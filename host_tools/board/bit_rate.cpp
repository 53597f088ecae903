#include "board/board_port.hpp"

// A file of its own: Linux' termbits.h and termios.h define the same names.
#ifdef __linux__
#include <asm/termbits.h>
#include <sys/ioctl.h>

bool fogcomp::board::set_bit_rate(int device, std::uint32_t baud) {
  termios2 settings{};
  if (ioctl(device, TCGETS2, &settings) != 0) return false;
  settings.c_cflag &= ~static_cast<tcflag_t>(CBAUD | CBAUD << IBSHIFT);
  settings.c_cflag |= static_cast<tcflag_t>(BOTHER | BOTHER << IBSHIFT);
  settings.c_ispeed = baud;
  settings.c_ospeed = baud;
  return ioctl(device, TCSETS2, &settings) == 0;
}
#else
#include <termios.h>

// Elsewhere a speed is its number.
bool fogcomp::board::set_bit_rate(int device, std::uint32_t baud) {
  termios settings{};
  return tcgetattr(device, &settings) == 0 && cfsetspeed(&settings, baud) == 0 &&
         tcsetattr(device, TCSANOW, &settings) == 0;
}
#endif
