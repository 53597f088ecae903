#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/bytes/crc.hpp"
#include "model/network.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::model {

// Shared by reader and writer of a model file.

inline constexpr const char* kHistory = "history";
inline constexpr const char* kHistoryFloor = "history_floor_dph";
inline constexpr const char* kHistoryHoldout = "history_holdout_dph";
inline constexpr const char* kHistoryForced = "history_forced";
inline constexpr const char* kEventRecording = "event_recording";
inline constexpr const char* kOthersFollow = "others_follow";
inline constexpr const char* kOthersPart = "others_part";
inline constexpr const char* kOnBoard = "on_board";
inline constexpr const char* kTitleLine = "fogcomp-model 2";

/// CRC-32 of the first `size` characters.
inline std::uint32_t crc_of(const std::string& text, std::size_t size) {
  return fog::crc32(reinterpret_cast<const std::uint8_t*>(text.data()), size);
}

/// Writes a model file: words separated by spaces, lines that begin with a keyword.
class ModelWriter {
 public:
  ModelWriter& word(const std::string& text) {
    if (!text_.empty() && text_.back() != '\n') text_ += ' ';
    text_ += text;
    return *this;
  }
  ModelWriter& number(double value) {
    char digits[40];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    return word(std::string(digits, end));
  }
  template <class Values>
  ModelWriter& numbers(const Values& values) {
    for (const double value : values) number(value);
    return *this;
  }
  /// A member of each.
  template <class Values, class Member>
  ModelWriter& each(const Values& values, Member member) {
    for (const auto& value : values) number(value.*member);
    return *this;
  }
  ModelWriter& hash(std::uint64_t value) {
    return word(format("%016llx", static_cast<unsigned long long>(value)));
  }
  void end_line() { text_ += '\n'; }
  std::string& text() { return text_; }

 private:
  std::string text_;
};

/// Reads the lines of a model file, word by word. Every failure is an InputError with the line.
class ModelReader {
 public:
  ModelReader(const std::string& text, std::string file)
      : lines_(split(text, '\n')), file_(std::move(file)) {}

  /// False at the end, and at an empty line.
  bool next_line() {
    if (line_ == lines_.size()) return false;
    words_ = split(lines_[line_++], ' ');
    position_ = 0;
    return !words_.empty();
  }

  bool at_end_of_line() const { return position_ == words_.size(); }
  std::string word() {
    if (position_ == words_.size()) fail("the line is too short");
    return words_[position_++];
  }
  std::string rest_of_line() {
    std::string text = word();
    while (position_ < words_.size()) text += ' ' + words_[position_++];
    return text;
  }
  double number() {
    const std::string text = word();
    const auto value = parse_number(text);
    if (!value) fail("'" + text + "' is not a number");
    return *value;
  }
  /// From `min` to `max`.
  double number(double min, double max) {
    const double value = number();
    if (value < min || value > max) {
      fail(format("%g is outside %g to %g", value, min, max));
    }
    return value;
  }
  /// Above 0.
  double positive() {
    const double value = number();
    if (value <= 0) fail("a value must be above 0");
    return value;
  }
  /// 0 to `max`.
  std::size_t count(std::size_t max) {
    return static_cast<std::size_t>(integer(0, static_cast<double>(max)));
  }
  std::int64_t integer(double min, double max) {
    const double value = number();
    if (value < min || value > max || value != std::trunc(value)) {
      fail("a whole number is out of range");
    }
    return static_cast<std::int64_t>(value);
  }
  std::vector<double> numbers(std::size_t size) { return numbers(size, -kAny, kAny); }
  std::vector<double> numbers(std::size_t size, double min, double max) {
    std::vector<double> values(size);
    for (double& value : values) value = number(min, max);
    return values;
  }
  /// As ModelWriter::hash() writes it.
  std::uint64_t hash() {
    const std::string text = word();
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    if (error != std::errc{} || end != text.data() + text.size()) {
      fail("'" + text + "' is not a hash");
    }
    return value;
  }
  /// One of `choices`, by its name_of().
  template <class Enum, std::size_t N>
  Enum named(const std::array<Enum, N>& choices) {
    const std::string text = word();
    for (const Enum choice : choices) {
      if (text == name_of(choice)) return choice;
    }
    fail("'" + text + "' is unknown");
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file_ + ":" + std::to_string(line_), what + "; fit the model again");
  }

 private:
  static constexpr double kAny = std::numeric_limits<double>::max();

  std::vector<std::string> lines_;
  std::string file_;
  std::size_t line_ = 0;
  std::vector<std::string> words_;
  std::size_t position_ = 0;
};

}  // namespace fogcomp::model
