#include "board/board_texts.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>

#include "model/model.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::board {
namespace {

constexpr std::array<const char*, fog::SerialLine::kFormats> kFormats{"8N1", "8N2", "8E1",
                                                                      "8E2", "8O1", "8O2"};

// In the order of the bits (firmware/SPEC.md, "Status flags").
constexpr const char* kFlagNames[] = {
    "gyro_invalid",        "rate_out_of_range",   "gyro_stuck",       "sequence_gap",
    "temperature_invalid", "temperature_clamped", "drift_held",       "drift_given_up",
    "thermal_settling",    "denoiser_filling",    "model_refused",    "denoised_invalid",
    "input_missing",       "rate_jump",           "temperature_jump", "temperature_frozen",
    "self_test_failed",    "sample_rate",         "history_unknown",  "drift_outdated",
    "rate_refused",        "denoised_refused",    "no_samples"};

fog::Status flag(std::size_t bit) {
  return static_cast<fog::Status>(1U << bit);
}

}  // namespace

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

std::vector<std::string> flag_names(fog::Status status) {
  std::vector<std::string> names;
  for (std::size_t bit = 0; bit < std::size(kFlagNames); ++bit) {
    if (has_any(status, flag(bit))) names.emplace_back(kFlagNames[bit]);
  }
  return names;
}

fog::Status parse_flags(const std::string& list, fog::Status allowed, const std::string& who) {
  fog::Status flags = fog::Status::none;
  if (list == "none") return flags;
  for (const std::string& name : split(list, ',')) {
    const auto found = std::find(std::begin(kFlagNames), std::end(kFlagNames), name);
    const auto bit = static_cast<std::size_t>(found - std::begin(kFlagNames));
    if (found == std::end(kFlagNames) || !has_any(allowed, flag(bit))) {
      throw InputError(who, "'" + name + "' is none of " + join(flag_names(allowed), ", ") +
                                "; write some of them with commas between, or none");
    }
    flags |= flag(bit);
  }
  return flags;
}

}  // namespace fogcomp::board
