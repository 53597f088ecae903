#include "support/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <numeric>

namespace fogcomp {
namespace {

// Optimal string alignment: insert, delete, substitute, swap neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(above);
    above.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitute = above[j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, substitute});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
  }
  return row[b.size()];
}

// Whether the parts of `word` begin parts of the candidate, in order: "temp_rate" for
// "temperature_rate_product", "--lot" for "--prior-lot".
bool abbreviates(std::string_view word, const std::string& candidate) {
  const auto parts_of = [](std::string text) {
    std::replace(text.begin(), text.end(), '-', '_');
    return split(text, '_');
  };
  const std::vector<std::string> beginnings = parts_of(std::string(word));
  std::size_t next = 0;
  for (const std::string& part : parts_of(candidate)) {
    if (next < beginnings.size() && part.rfind(beginnings[next], 0) == 0) ++next;
  }
  return !beginnings.empty() && next == beginnings.size();
}

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

// For each UTF-8 character, and for each byte that is not UTF-8.
template <class Use>
void for_each_character(std::string_view text, const Use& use) {
  while (!text.empty()) {
    const std::size_t length = std::max<std::size_t>(utf8_length(text), 1);
    use(text.substr(0, length));
    text.remove_prefix(length);
  }
}

// U+0080 to U+009F, which some terminals execute, are C2 80 to C2 9F.
bool is_control(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  const auto second_set = [](unsigned char code) { return code >= 0x80U && code < 0xA0U; };
  if (character.size() == 1) return byte(0) < 0x20U || byte(0) == 0x7FU || second_set(byte(0));
  return byte(0) == 0xC2U && second_set(byte(1));
}

}  // namespace

std::string format(const char* pattern, ...) {
  va_list arguments;
  va_start(arguments, pattern);
  va_list again;
  va_copy(again, arguments);
  const int size = std::vsnprintf(nullptr, 0, pattern, arguments);
  va_end(arguments);
  std::string text(static_cast<std::size_t>(std::max(size, 0)), '\0');
  std::vsnprintf(text.data(), text.size() + 1, pattern, again);
  va_end(again);
  return text;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  if (text.empty()) return parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::string join(const std::vector<std::string>& words, std::string_view separator) {
  std::string text;
  for (const std::string& word : words) {
    if (&word != &words.front()) text += separator;
    text += word;
  }
  return text;
}

std::string join_list(const std::vector<std::string>& words, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 < words.size() ? ", " : " " + std::string(last) + " ";
    text += words[i];
  }
  return text;
}

std::string shell_word(const std::string& word) {
  if (word == "-") return "FILE";
  const auto is_plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("_./,:=+-@%").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string shell_words(const std::vector<std::string>& words) {
  std::vector<std::string> quoted;
  for (const std::string& word : words) quoted.push_back(shell_word(word));
  return join(quoted, " ");
}

std::string_view trim(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::optional<double> parse_number(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size() ||
      !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::string rounded(double value) {
  constexpr int kMaxDecimals = 6;
  const double size = std::fabs(value);
  if (!std::isfinite(value)) return "-";
  if (size < 0.5e-6) return "0";  // and never "-0"
  const int order = static_cast<int>(std::floor(std::log10(size)));
  return format("%.*f", std::clamp(3 - order, 0, kMaxDecimals), value);
}

std::string signed_rounded(double value) {
  const std::string text = rounded(value);
  return text[0] == '-' ? text : "+" + text;
}

std::string time_text(double seconds) {
  constexpr double kMinute = 60;
  constexpr double kHour = 3600;
  if (seconds < 2 * kMinute) return format("%.3g s", seconds);
  if (seconds < 2 * kHour) return format("%.3g min", seconds / kMinute);
  return format("%.3g h", seconds / kHour);
}

std::string counted(std::size_t count, const std::string& noun) {
  return format("%zu %s%s", count, noun.c_str(), count == 1 ? "" : "s");
}

std::size_t utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80U) return 1;
  // C0 and C1 would be overlong ASCII, F5 and above is beyond Unicode.
  const std::size_t length = first < 0xC2U ? 0U : first < 0xE0U ? 2U : first < 0xF0U ? 3U : 4U;
  if (length == 0 || first > 0xF4U || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  }
  const unsigned second = byte(1);
  const bool too_long = (first == 0xE0U && second < 0xA0U) || (first == 0xF0U && second < 0x90U);
  const bool surrogate = first == 0xEDU && second >= 0xA0U;
  const bool beyond = first == 0xF4U && second >= 0x90U;
  return too_long || surrogate || beyond ? 0 : length;
}

std::string valid_utf8(std::string_view text) {
  std::string valid;
  for_each_character(text, [&](std::string_view character) {
    valid += utf8_length(character) == 0 ? kReplacement : character;
  });
  return valid;
}

bool has_control_character(std::string_view text) {
  bool found = false;
  for_each_character(text, [&](std::string_view character) { found |= is_control(character); });
  return found;
}

std::string displayable(std::string_view text) {
  std::string shown;
  for_each_character(text, [&](std::string_view character) {
    shown += is_control(character) ? "?" : valid_utf8(character);
  });
  return shown;
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  std::size_t best = std::max<std::size_t>(1, word.size() / 3) + 1;
  std::string found;
  for (const std::string& candidate : candidates) {
    const auto [shorter, longer] = std::minmax({word.size(), candidate.size()});
    if (longer - shorter >= best) continue;  // minimum number of insertions
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best) {
      best = distance;
      found = candidate;
    }
  }
  if (!found.empty() || word.empty()) return found;
  const auto begins = [&](const std::string& candidate) {
    return candidate.compare(0, word.size(), word) == 0;
  };
  const auto begun = std::find_if(candidates.begin(), candidates.end(), begins);
  const bool only = std::count_if(candidates.begin(), candidates.end(), begins) == 1;
  return only ? *begun : "";
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  std::vector<std::string> found{nearest(word, candidates)};
  if (found[0].empty()) {
    found.clear();
    std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(found),
                 [&](const std::string& candidate) { return abbreviates(word, candidate); });
  }
  constexpr std::size_t kMaxShown = 4;
  if (found.empty() || found.size() > kMaxShown) return "";
  return " (did you mean '" + join(found, "' or '") + "'?)";
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t first = 0; first < bytes.size(); first += 3) {
    const std::string_view part = bytes.substr(first, 3);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      bits = bits << 8U | (i < part.size() ? static_cast<unsigned char>(part[i]) : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      text += i <= part.size() ? kDigits[bits >> (18 - 6 * i) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace fogcomp
