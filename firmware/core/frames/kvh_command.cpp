#include "core/frames/kvh_command.hpp"

#include "core/frames/kvh_bit.hpp"

namespace fog {
namespace {

bool equal(const char* a, const char* b) {
  while (*a == *b && *a != '\0') {
    ++a;
    ++b;
  }
  return *a == *b;
}

// One line of an answer.
class Line {
 public:
  explicit Line(std::uint8_t* out) : out_(out) {}
  Line& text(const char* text) {
    for (; *text != '\0'; ++text) out_[size_++] = static_cast<std::uint8_t>(*text);
    return *this;
  }
  Line& decimal(std::uint32_t value) {
    char digits[11] = {};
    std::size_t first = sizeof digits - 1;
    do {
      digits[--first] = static_cast<char>('0' + value % 10);
      value /= 10;
    } while (value != 0);
    return text(&digits[first]);
  }
  std::size_t end() { return text("\r\n").size_; }

 private:
  std::uint8_t* out_;
  std::size_t size_ = 0;
};

char upper_case(std::uint8_t byte) {
  const char character = static_cast<char>(byte);
  return character >= 'a' && character <= 'z' ? static_cast<char>(character - 'a' + 'A')
                                              : character;
}

}  // namespace

std::size_t KvhCommands::feed(std::uint8_t byte, std::uint8_t* out, Status status) {
  if (byte == '=' || byte == '?') {
    size_ = 0;  // starts a command; these characters do not occur within one
  } else if (byte == '\r' || byte == '\n') {
    const bool whole = size_ > 1 && size_ < kMaxLine;
    line_[whole ? size_ : 0] = '\0';
    size_ = 0;
    return whole ? answer(out, status) : 0;
  } else if (size_ == 0 || size_ == kMaxLine) {
    return 0;
  }
  if (byte < ' ' || byte > '~') {
    size_ = 0;
    return 0;
  }
  line_[size_++] = upper_case(byte);
  return 0;
}

// A command is answered by itself without its first character, a query by that and its value. The
// built-in tests are asked for in both modes.
std::size_t KvhCommands::answer(std::uint8_t* out, Status status) {
  Line line(out);
  const char* const command = line_.data();
  const bool extended = equal(command, "?BIT,2");
  if (extended || equal(command, "?BIT")) return encode_kvh_bit(status, extended, out);
  if (equal(command, "=CONFIG,1")) {
    configuring_ = true;
    return line.text(command + 1).end();
  }
  if (!configuring_) return 0;
  if (equal(command, "=CONFIG,0")) {
    configuring_ = false;  // the only command without an answer
    return 0;
  }
  const std::size_t known = answer_setting(out);
  return known > 0 ? known : line.text("INVALID,").text(command).end();
}

// 0 if the line is no query of a setting, nor a command that leaves it as it is.
std::size_t KvhCommands::answer_setting(std::uint8_t* out) const {
  struct Setting {
    const char* name;
    const char* value;  // nullptr: the number
    std::uint32_t number;
  };
  const Setting settings[] = {{"ROTFMT,", settings_.delta_angle ? "DELTA" : "RATE", 0},
                              {"ROTUNITS,", "RAD", 0},
                              {"TEMPUNITS,", "C", 0},
                              {"MSYNC,", "IMU", 0},
                              {"DR,", nullptr, settings_.sample_rate_hz},
                              {"BAUD,", nullptr, settings_.baud}};
  const char* const command = line_.data();
  for (const Setting& setting : settings) {
    Line known(out);
    known.text(setting.name);
    setting.value != nullptr ? known.text(setting.value) : known.decimal(setting.number);
    const std::size_t size = known.end();
    std::size_t same = 0;
    while (command[1 + same] == static_cast<char>(out[same])) ++same;
    // A query ends where the value begins, a command where the answer ends.
    const char next = static_cast<char>(out[same]);
    if (command[1 + same] == '\0' && next == (command[0] == '?' ? ',' : '\r')) return size;
  }
  return 0;
}

}  // namespace fog
