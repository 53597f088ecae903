#include "findings/text.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace fogcomp::findings {
namespace {

constexpr std::pair<std::string_view, std::string_view> kSigns[] = {
    {"sqrt(h)", "√h"}, {"sqrt(", "√("}, {"deg/", "°/"},  {"degC", "°C"}, {"+-", "±"},
    {"chi^2", "χ²"},   {"^2", "²"},     {" -> ", " → "}, {" - ", " − "}, {" x ", " × "},
};

bool begins_with(std::string_view text, std::string_view word) {
  return !word.empty() && text.substr(0, word.size()) == word;
}

}  // namespace

Text::Text(const char* literal) : Text(words(literal)) {}

std::string Text::sentence() const {
  std::string text = typeset_;
  if (text.empty()) return text;
  const bool identifier = text.find('_') < text.find(' ');  // of an effect, say: as it is typed
  if (!begins_with_name_ && !identifier && text[0] >= 'a' && text[0] <= 'z') {
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  }
  if (std::string(".:?").find(text.back()) == std::string::npos) text += '.';
  return text;
}

Text& Text::operator+=(const Text& more) {
  if (empty()) begins_with_name_ = more.begins_with_name_;
  plain_ += more.plain_;
  typeset_ += more.typeset_;
  return *this;
}

Text operator+(Text begin, const Text& end) {
  begin += end;
  return begin;
}

Text words(std::string_view sentence, const std::vector<std::string>& names) {
  Text text;
  text.plain_ = sentence;
  bool quoted = false;
  while (!sentence.empty()) {
    const auto name = std::find_if(names.begin(), names.end(), [&](const std::string& one) {
      return begins_with(sentence, one);
    });
    const auto* const sign =
        std::find_if(std::begin(kSigns), std::end(kSigns),
                     [&](const auto& one) { return begins_with(sentence, one.first); });
    std::size_t taken = 1;
    if (name != names.end()) {
      taken = name->size();
      if (text.typeset_.empty()) text.begins_with_name_ = true;
      text.typeset_ += *name;
    } else if (sign != std::end(kSigns)) {
      taken = sign->first.size();
      text.typeset_ += sign->second;
    } else if (sentence[0] == '`') {
      text.typeset_ += quoted ? "’" : "‘";
      quoted = !quoted;
    } else {
      text.typeset_ += sentence[0];
    }
    sentence.remove_prefix(taken);
  }
  return text;
}

Text verbatim(const std::string& name) {
  Text text;
  text.plain_ = text.typeset_ = name;
  text.begins_with_name_ = true;
  return text;
}

std::vector<std::string> short_names(const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  for (const std::string& path : paths) {
    names.push_back(std::filesystem::path(path).filename().string());
  }
  std::vector<std::string> unique = names;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (std::count(names.begin(), names.end(), names[i]) > 1) unique[i] = paths[i];
  }
  return unique;
}

}  // namespace fogcomp::findings
