#include "board/identity.hpp"

#include <cctype>

#include "model/serial_number.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::board {

std::array<std::uint32_t, fog::kSerialWords> serial_words(const std::string& serial) {
  std::array<std::uint32_t, fog::kSerialWords> words{};
  if (serial.empty()) return words;
  if (!model::is_serial_number(serial)) {
    throw InputError("--serial",
                     format("'%s' does not fit a board; give 1 to %zu characters of ASCII "
                            "without spaces",
                            serial.c_str(), model::kMaxSerial));
  }
  for (std::size_t i = 0; i < serial.size(); ++i) {
    words[i / 4] |= std::uint32_t{static_cast<unsigned char>(serial[i])} << (8 * (i % 4));
  }
  return words;
}

std::string serial_text(const std::uint32_t* words) {
  std::string text;
  for (std::size_t i = 0; i < model::kMaxSerial; ++i) {
    const auto character = static_cast<char>((words[i / 4] >> (8 * (i % 4))) & 0xFFU);
    if (character == '\0') break;
    text += character;
  }
  return text;
}

ProcessorNumber parse_processor_number(const std::string& text) {
  constexpr std::size_t kDigits = 8;
  bool digits = text.size() == kDigits * fog::kProcessorWords;
  for (const char character : text) {
    digits = digits && std::isxdigit(static_cast<unsigned char>(character)) != 0;
  }
  ProcessorNumber number{};
  for (std::size_t i = 0; digits && i < number.size(); ++i) {
    number[i] =
        static_cast<std::uint32_t>(std::stoul(text.substr(kDigits * i, kDigits), nullptr, 16));
  }
  if (number != ProcessorNumber{}) return number;
  throw InputError("--uid",
                   "'" + text +
                       "' is not a processor's number; give the 24 hexadecimal digits that "
                       "fogcomp health prints of the board");
}

std::string processor_text(const ProcessorNumber& number) {
  return format("%08x%08x%08x", static_cast<unsigned>(number[0]), static_cast<unsigned>(number[1]),
                static_cast<unsigned>(number[2]));
}

}  // namespace fogcomp::board
