#include "board/board_port.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "board/board_texts.hpp"
#include "support/input_error.hpp"

namespace fogcomp::board {
namespace {

constexpr int kWritePatienceMs = 1000;

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw InputError(path, what + ": " + std::strerror(errno));
}

int connect_to_socket(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) {
    throw InputError(path, "the name of a socket is shorter than " +
                               std::to_string(sizeof address.sun_path) + " characters");
  }
  path.copy(address.sun_path, path.size());
  const int connection = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (connection < 0) fail(path, "no socket");
  if (connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    const int reason = errno;
    close(connection);
    errno = reason;
    fail(path, "cannot connect");
  }
  return connection;
}

int open_device(const std::string& path) {
  const int device = open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (device < 0) fail(path, "cannot open");
  if (isatty(device) == 0) {
    close(device);
    throw InputError(path, "is neither a serial device nor a socket; give the board's output port");
  }
  return device;
}

// Sets all but the bit rate.
bool set_format(int device, fog::SerialLine line) {
  termios settings{};
  if (tcgetattr(device, &settings) != 0) return false;
  cfmakeraw(&settings);
  settings.c_cflag &= ~static_cast<tcflag_t>(PARENB | PARODD | CSTOPB);
  settings.c_cflag |= static_cast<tcflag_t>(CLOCAL | CREAD);
  if (line.has_parity()) settings.c_cflag |= static_cast<tcflag_t>(PARENB);
  if (line.has_odd_parity()) settings.c_cflag |= static_cast<tcflag_t>(PARODD);
  if (line.has_two_stop_bits()) settings.c_cflag |= static_cast<tcflag_t>(CSTOPB);
  return tcsetattr(device, TCSANOW, &settings) == 0;
}

}  // namespace

BoardPort::BoardPort(const std::string& path, fog::SerialLine line) : path_(path) {
  struct stat about {};
  if (stat(path.c_str(), &about) != 0) fail(path, "cannot open (is the board connected?)");
  descriptor_ = S_ISSOCK(about.st_mode) ? connect_to_socket(path) : open_device(path);
  try {
    set_line(line);
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

void BoardPort::set_line(fog::SerialLine line) {
  if (isatty(descriptor_) == 0) return;
  if (!set_format(descriptor_, line) || !set_bit_rate(descriptor_, line.baud())) {
    fail(path_, "cannot be set to " + line_text(line));
  }
}

BoardPort::~BoardPort() {
  close(descriptor_);
}

void BoardPort::write(const std::uint8_t* bytes, std::size_t size) {
  std::size_t written = 0;
  while (written < size) {
    pollfd waiting{descriptor_, POLLOUT, 0};
    if (poll(&waiting, 1, kWritePatienceMs) <= 0) throw InputError(path_, "takes no bytes");
    const ssize_t count = ::write(descriptor_, bytes + written, size - written);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    if (count <= 0) fail(path_, "cannot be written");
    written += static_cast<std::size_t>(count);
  }
}

std::size_t BoardPort::read(std::uint8_t* bytes, std::size_t capacity, int patience_ms) {
  pollfd waiting{descriptor_, POLLIN, 0};
  if (poll(&waiting, 1, patience_ms) <= 0) return 0;
  const ssize_t count = ::read(descriptor_, bytes, capacity);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return 0;
  if (count < 0) fail(path_, "cannot be read");
  if (count == 0) throw InputError(path_, "the other side has closed the connection");
  return static_cast<std::size_t>(count);
}

}  // namespace fogcomp::board
