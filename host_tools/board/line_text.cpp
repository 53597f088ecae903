#include "board/line_text.hpp"

#include <array>
#include <cmath>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::board {
namespace {

constexpr std::array<const char*, fog::SerialLine::kFormats> kFormats{"8N1", "8N2", "8E1",
                                                                      "8E2", "8O1", "8O2"};

}  // namespace

std::string line_text(fog::SerialLine line) {
  const std::uint32_t format_number = line.word() >> fog::SerialLine::kStopBit;
  return std::to_string(line.baud()) +
         (format_number == 0 ? "" : "," + std::string(kFormats.at(format_number)));
}

fog::SerialLine parse_line(const std::string& text, std::uint32_t max_baud,
                           const std::string& option) {
  const std::size_t comma = text.find(',');
  const std::string format_name = comma == std::string::npos ? "8N1" : text.substr(comma + 1);
  const auto baud = parse_number(text.substr(0, comma));
  const bool is_rate =
      baud && *baud >= fog::SerialLine::kMinBaud && *baud <= max_baud && std::floor(*baud) == *baud;
  for (std::uint32_t i = 0; is_rate && i < kFormats.size(); ++i) {
    if (format_name != kFormats.at(i)) continue;
    return fog::SerialLine(static_cast<std::uint32_t>(*baud) | i << fog::SerialLine::kStopBit);
  }
  throw InputError(option + " " + text,
                   format("is not BAUD or BAUD,FORMAT: %u to %u Bd, and 8N1, 8N2, 8E1, 8E2, 8O1 or "
                          "8O2",
                          fog::SerialLine::kMinBaud, max_baud));
}

}  // namespace fogcomp::board
