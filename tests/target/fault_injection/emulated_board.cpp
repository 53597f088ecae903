#include "emulated_board.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <thread>

namespace fogcomp::injection {
namespace {

using namespace std::chrono_literals;

constexpr auto kStartPatience = 20s;
constexpr int kDebugPatienceMs = 10000;
constexpr int kGatherMs = 1;

std::string hex(std::uint32_t value, int digits) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%0*x", digits, value);
  return text.data();
}

}  // namespace

EmulatedBoard::EmulatedBoard(const std::string& machine, const std::string& elf) {
  signal(SIGPIPE, SIG_IGN);
  std::string pattern = (std::filesystem::temp_directory_path() / "fog_board_XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  folder_ = pattern;
  start(machine, elf);
}

EmulatedBoard::~EmulatedBoard() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  for (const int port : {output_port_, sensor_port_, console_port_, debug_port_}) {
    if (port >= 0) close(port);
  }
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void EmulatedBoard::start(const std::string& machine, const std::string& elf) {
  std::vector<std::string> words{"qemu-system-arm", "-M",   machine, "-display", "none",
                                 "-monitor",        "none", "-S",    "-kernel",  elf};
  // QEMU writes byte by byte: into a file that costs neither of us a change of process.
  words.insert(words.end(), {"-serial", "file:" + folder_ + "/output"});
  for (const char* port : {"sensor", "console"}) {
    words.insert(words.end(), {"-serial", "unix:" + folder_ + "/" + port + ",server=on,wait=off"});
  }
  words.insert(words.end(),
               {"-chardev", "socket,id=debug,server=on,wait=off,path=" + folder_ + "/debug", "-gdb",
                "chardev:debug"});
  process_ = fork();
  if (process_ < 0) throw std::runtime_error("fork failed");
  if (process_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // even if this program is killed outright
    const int log = open((folder_ + "/log").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(log, 1);
    dup2(log, 2);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  sensor_port_ = connect_to("sensor");
  console_port_ = connect_to("console");
  debug_port_ = connect_to("debug");
  for (const int port : {sensor_port_, console_port_}) fcntl(port, F_SETFL, O_NONBLOCK);
  output_port_ = open((folder_ + "/output").c_str(), O_RDONLY | O_CLOEXEC);
  if (output_port_ < 0) throw std::runtime_error("QEMU does not open its output");
  debug_input_.clear();
  command("?");
}

int EmulatedBoard::connect_to(const std::string& port) {
  const auto deadline = std::chrono::steady_clock::now() + kStartPatience;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, (folder_ + "/" + port).c_str(), sizeof address.sun_path - 1);
  while (std::chrono::steady_clock::now() < deadline) {
    const int connection = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (connect(connection, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) {
      return connection;
    }
    close(connection);
    std::this_thread::sleep_for(2ms);
  }
  throw std::runtime_error("QEMU does not open its port " + port);
}

// ---- debug port: "$text#checksum", each acknowledged with "+" (GDB manual, "Remote Protocol")
// ----

void EmulatedBoard::send_all(int socket, const std::string& text) {
  std::size_t sent = 0;
  while (sent < text.size()) {
    const ssize_t count = send(socket, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (count <= 0) throw std::runtime_error("the debug port is gone");
    sent += static_cast<std::size_t>(count);
  }
}

std::string EmulatedBoard::receive_packet() {
  for (;;) {
    const std::size_t from = debug_input_.find('$');
    const std::size_t to = debug_input_.find('#', from == std::string::npos ? 0 : from);
    if (from != std::string::npos && to != std::string::npos && debug_input_.size() >= to + 3) {
      std::string packet = debug_input_.substr(from + 1, to - from - 1);
      debug_input_.erase(0, to + 3);
      send_all(debug_port_, "+");
      return packet;
    }
    pollfd waiting{debug_port_, POLLIN, 0};
    if (poll(&waiting, 1, kDebugPatienceMs) <= 0) throw std::runtime_error("QEMU is silent");
    std::array<char, 4096> bytes;
    const ssize_t count = recv(debug_port_, bytes.data(), bytes.size(), 0);
    if (count <= 0) throw std::runtime_error("the debug port is gone");
    debug_input_.append(bytes.data(), static_cast<std::size_t>(count));
  }
}

std::string EmulatedBoard::command(const std::string& packet) {
  std::uint32_t sum = 0;
  for (const char c : packet) sum += static_cast<std::uint8_t>(c);
  send_all(debug_port_, "$" + packet + "#" + hex(sum & 0xFFU, 2));
  return receive_packet();
}

std::uint8_t EmulatedBoard::read_byte(std::uint32_t address) {
  const std::string answer = command("m" + hex(address, 1) + ",1");
  if (answer.size() != 2) throw std::runtime_error("cannot read address " + hex(address, 8));
  return static_cast<std::uint8_t>(std::stoul(answer, nullptr, 16));
}

void EmulatedBoard::write_byte(std::uint32_t address, std::uint8_t value) {
  if (command("M" + hex(address, 1) + ",1:" + hex(value, 2)) != "OK") {
    throw std::runtime_error("cannot write address " + hex(address, 8));
  }
}

void EmulatedBoard::flip(const Flip& flip) {
  const std::uint8_t byte = read_byte(flip.address);
  const auto flipped = static_cast<std::uint8_t>(byte ^ (1U << flip.bit));
  write_byte(flip.address, flipped);
  if (read_byte(flip.address) != flipped) throw std::runtime_error("the flip did not take");
}

void EmulatedBoard::resume() {
  send_all(debug_port_, "$c#63");
}

void EmulatedBoard::stop() {
  send_all(debug_port_, "\x03");
  receive_packet();
}

// ---- serial ports ----

void EmulatedBoard::send_to_sensor_port(const Bytes& bytes) {
  to_sensor_.insert(to_sensor_.end(), bytes.begin(), bytes.end());
}

bool EmulatedBoard::exchange(std::chrono::milliseconds patience) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  do {
    const bool came = take_output();
    if (exchange_at_sockets() || came) return true;
  } while (std::chrono::steady_clock::now() < deadline);
  return false;
}

bool EmulatedBoard::take_output() {
  std::array<std::uint8_t, 16384> bytes;
  const ssize_t count = read(output_port_, bytes.data(), bytes.size());
  if (count <= 0) return false;
  output.insert(output.end(), bytes.data(), bytes.data() + count);
  return true;
}

bool EmulatedBoard::exchange_at_sockets() {
  const short to_sensor = to_sensor_.empty() ? 0 : POLLOUT;
  std::array<pollfd, 2> ports{pollfd{console_port_, POLLIN, 0}, pollfd{sensor_port_, to_sensor, 0}};
  if (poll(ports.data(), ports.size(), kGatherMs) <= 0) return false;
  bool came = false;
  if ((ports[0].revents & (POLLIN | POLLHUP)) != 0) {
    std::array<std::uint8_t, 16384> bytes;
    const ssize_t count = recv(console_port_, bytes.data(), bytes.size(), 0);
    // It closes its ports some time before it ends.
    if (count == 0) throw QemuEnded();
    if (count > 0) {
      console.insert(console.end(), bytes.data(), bytes.data() + count);
      came = true;
    }
  }
  if ((ports[1].revents & POLLOUT) != 0) {
    const ssize_t count = send(sensor_port_, to_sensor_.data(), to_sensor_.size(), MSG_NOSIGNAL);
    if (count > 0) {
      to_sensor_.erase(to_sensor_.begin(), to_sensor_.begin() + count);
      came = true;
    }
  }
  return came;
}

std::size_t EmulatedBoard::times_said(const std::string& text) const {
  std::size_t times = 0;
  for (std::size_t at = console.find(text); at != std::string::npos;
       at = console.find(text, at + text.size())) {
    ++times;
  }
  return times;
}

}  // namespace fogcomp::injection
