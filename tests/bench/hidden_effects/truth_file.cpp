#include "truth_file.hpp"

#include <cstdlib>

#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::bench {

TruthFile::TruthFile(const std::string& path) {
  const std::string text = read_file(path);
  const char* at = text.c_str();
  while (*at == '#') {
    while (*at != '\n' && *at != 0) ++at;
    if (*at == '\n') ++at;
  }
  std::size_t end = text.find('\n', static_cast<std::size_t>(at - text.c_str()));
  if (end == std::string::npos) throw InputError(path, "has no header; make the case again");
  names_ = split(std::string_view(at, end - static_cast<std::size_t>(at - text.c_str())), ',');
  columns_.resize(names_.size());
  at = text.c_str() + end + 1;
  while (*at != 0) {
    for (std::vector<double>& column : columns_) {
      char* after = nullptr;
      column.push_back(std::strtod(at, &after));
      if (after == at) throw InputError(path, "has a row that is cut off; make the case again");
      at = after + (*after == 0 ? 0 : 1);
    }
  }
}

std::vector<double> TruthFile::sum_of(bool (*wanted)(const std::string&, const std::string&),
                                      const std::string& name) const {
  std::vector<double> sum(columns_[0].size(), 0);
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (!wanted(names_[i], name)) continue;
    for (std::size_t row = 0; row < sum.size(); ++row) sum[row] += columns_[i][row];
  }
  return sum;
}

std::vector<double> TruthFile::effect(const std::string& name) const {
  return sum_of(
      [](const std::string& column, const std::string& n) { return column == n + "_dph"; }, name);
}

std::vector<double> TruthFile::noise() const {
  return sum_of([](const std::string& column,
                   const std::string& n) { return column.compare(0, n.size(), n) == 0; },
                "noise_");
}

}  // namespace fogcomp::bench
