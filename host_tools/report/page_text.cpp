#include "report/page_text.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace fogcomp::report {
namespace {

constexpr std::pair<std::string_view, std::string_view> kSigns[] = {
    {"sqrt(h)", "√h"}, {"deg/", "°/"},  {"degC", "°C"},
    {"+-", "±"},       {"chi^2", "χ²"}, {" -> ", " → "},
};

bool begins_with(std::string_view text, std::string_view word) {
  return !word.empty() && text.substr(0, word.size()) == word;
}

}  // namespace

Text::Text(const char* literal) : Text(words(literal)) {}

Text& Text::operator+=(const Text& more) {
  utf8_ += more.utf8_;
  return *this;
}

Text operator+(Text begin, const Text& end) {
  begin += end;
  return begin;
}

Text words(std::string_view sentence, const std::vector<std::string>& names) {
  std::string shown;
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
      shown += *name;
    } else if (sign != std::end(kSigns)) {
      taken = sign->first.size();
      shown += sign->second;
    } else {
      shown += sentence[0];
    }
    sentence.remove_prefix(taken);
  }
  return verbatim(std::move(shown));
}

Text verbatim(std::string name) {
  Text text;
  text.utf8_ = std::move(name);
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

}  // namespace fogcomp::report
