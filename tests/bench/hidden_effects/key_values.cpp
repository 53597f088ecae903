#include "key_values.hpp"

#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::bench {

KeyValues::KeyValues(const std::string& path) : path_(path) {
  for (const std::string& line : split(read_file(path), '\n')) {
    if (!line.empty()) lines_.push_back(split(line, ' '));
  }
}

std::vector<std::vector<std::string>> KeyValues::all(const std::string& key) const {
  std::vector<std::vector<std::string>> found;
  for (const auto& line : lines_) {
    if (line[0] == key) found.emplace_back(line.begin() + 1, line.end());
  }
  return found;
}

std::string KeyValues::word(const std::string& key) const {
  const auto found = all(key);
  return found.empty() || found[0].empty() ? "" : found[0][0];
}

double KeyValues::number(const std::string& key) const {
  const auto parsed = parse_number(word(key));
  if (!parsed) throw InputError(path_, "has no number '" + key + "'; make the case again");
  return *parsed;
}

}  // namespace fogcomp::bench
