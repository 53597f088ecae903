#include "batch/limits.hpp"

#include <algorithm>
#include <sstream>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::batch {

std::vector<Limit> parse_limits(const std::string& text, const std::string& file,
                                const std::vector<std::string>& known) {
  std::vector<Limit> limits;
  const std::vector<std::string> lines = split(text, '\n');
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string line(trim(lines[i].substr(0, lines[i].find('#'))));
    if (line.empty()) continue;
    const std::string where = file + format(":%zu", i + 1);
    std::istringstream words(line);
    std::string figure;
    std::string relation;
    std::string number;
    words >> figure >> relation >> number;
    const auto value = parse_number(number);
    if (!value || (relation != "<=" && relation != ">=") || words.rdbuf()->in_avail() > 0) {
      throw InputError(where,
                       "'" + line + "' is no limit; write FIGURE <= NUMBER or FIGURE >= NUMBER");
    }
    if (std::find(known.begin(), known.end(), figure) == known.end()) {
      throw InputError(where, "there is no figure '" + figure + "'" + did_you_mean(figure, known) +
                                  "; the columns of gyros.csv are figures");
    }
    limits.push_back({figure, relation == "<=", *value});
  }
  return limits;
}

std::string broken_limits(const GyroResult& result, const std::vector<Limit>& limits) {
  std::string text;
  for (const Limit& limit : limits) {
    const auto value = result.figure(limit.figure);
    if (value && limit.meets(*value)) continue;
    text += (text.empty() ? "" : "; ") + limit.figure + " " +
            (value ? format("%.4g", *value) : "is missing") + ", must be " +
            format("%s %g", limit.is_max ? "<=" : ">=", limit.value);
  }
  return text;
}

}  // namespace fogcomp::batch
