#include "recording/cut.hpp"

#include "recording/mask.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {

Cut parse_cut(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  const std::string time = colon == std::string::npos ? text : text.substr(colon + 1);
  const auto at_s = parse_number(time);
  if (!at_s) {
    throw InputError("--cut '" + text + "'",
                     "is not a time in seconds since power-on, as 3600, nor RUN:3600");
  }
  return {colon == std::string::npos ? "" : text.substr(0, colon), *at_s};
}

std::string cut_text(const Cut& cut) {
  return (cut.run.empty() ? "" : cut.run + ":") + format("%.10g", cut.at_s);
}

void require_cut_runs(const std::vector<Cut>& cuts, const std::vector<std::string>& runs) {
  for (const Cut& cut : cuts) require_file_of("--cut", cut.run, runs);
}

}  // namespace fogcomp::recording
