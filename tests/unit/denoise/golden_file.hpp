#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

// The golden vectors of tests/golden/wavelet.
namespace fog::test {

/// The words of every line but comments.
inline std::vector<std::vector<std::string>> golden_lines(const std::string& name) {
  std::ifstream file(std::string(FOG_SOURCE_DIR) + "/tests/golden/wavelet/" + name);
  EXPECT_TRUE(file.good()) << name;
  std::vector<std::vector<std::string>> lines;
  std::string line;
  while (std::getline(file, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream stream(line);
    lines.emplace_back();
    std::string word;
    while (stream >> word) lines.back().push_back(word);
  }
  return lines;
}

/// The words from `first` on as numbers.
inline std::vector<double> numbers(const std::vector<std::string>& words, std::size_t first) {
  std::vector<double> values;
  for (std::size_t i = first; i < words.size(); ++i) values.push_back(std::stod(words[i]));
  return values;
}

/// make_golden.py's signal(): the same integers in every language.
inline std::vector<double> golden_signal(std::size_t size) {
  std::vector<double> values;
  for (std::size_t index = 0; index < size; ++index) {
    const auto i = static_cast<std::int64_t>(index);
    values.push_back(static_cast<double>((i * i * 7919 + i * 104729 + 31) % 2003 - 1001) / 1024);
  }
  return values;
}

}  // namespace fog::test
