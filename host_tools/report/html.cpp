#include "report/html.hpp"

#include <algorithm>
#include <stdexcept>

#include "support/text.hpp"

namespace fogcomp::report {
namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

}  // namespace

std::string escaped(std::string text) {
  text = valid_utf8(text);
  replace_all(text, "&", "&amp;");
  replace_all(text, "<", "&lt;");
  replace_all(text, ">", "&gt;");
  replace_all(text, "\"", "&quot;");
  return text;
}

std::string escaped(const findings::Text& text) {
  return escaped(text.typeset());
}

std::string script_data(const Json& json) {
  std::string text = json.text();
  replace_all(text, "<", "\\u003c");
  return text;
}

const std::string& file_of(const std::vector<EmbeddedFile>& files, const std::string& name) {
  for (const EmbeddedFile& one : files) {
    if (one.name == name) return one.text;
  }
  throw std::logic_error("no file '" + name + "' was compiled in");
}

std::string filled(const std::string& frame,
                   const std::vector<std::pair<std::string, std::string>>& parts) {
  std::string page;
  std::size_t at = 0;
  while (true) {
    const std::size_t open = frame.find("{{", at);
    page.append(frame, at, open - at);
    if (open == std::string::npos) return page;
    const std::size_t close = frame.find("}}", open);
    const std::string name = frame.substr(open + 2, close - open - 2);
    const auto part = std::find_if(parts.begin(), parts.end(),
                                   [&](const auto& one) { return one.first == name; });
    if (part == parts.end()) throw std::logic_error("no part '" + name + "' for the page");
    page += part->second;
    at = close + 2;
  }
}

}  // namespace fogcomp::report
