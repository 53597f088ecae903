#include "recording/mask.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {

bool names_file(const std::string& run, const std::string& path) {
  return run.empty() || run == path || run == path.substr(path.rfind('/') + 1);
}

namespace {

// Throws InputError if the run of one of an option's values is none of the files.
template <class OfRun>
void require_runs(const char* option, const std::vector<OfRun>& values,
                  const std::vector<std::string>& files) {
  for (const OfRun& each : values) {
    const auto is_run = [&](const std::string& file) { return names_file(each.run, file); };
    if (std::any_of(files.begin(), files.end(), is_run)) continue;
    throw InputError(option, "names " + each.run + ", which is none of the runs");
  }
}

// Of "RUN:TIMES", or of TIMES alone.
std::pair<std::string, std::string> run_and_times(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) return {"", text};
  return {text.substr(0, colon), text.substr(colon + 1)};
}

}  // namespace

Mask parse_mask(const std::string& text) {
  const auto fail = [&](const std::string& what) {
    throw InputError("--mask '" + text + "'", what);
  };
  const auto [run, times] = run_and_times(text);
  const std::size_t dots = std::min(times.find(".."), times.size());
  const auto from = parse_number(times.substr(0, dots));
  const auto to = parse_number(times.substr(std::min(dots + 2, times.size())));
  if (!from || !to) {
    fail("is not FROM..TO in seconds since power-on, as 3600..7200, nor RUN:FROM..TO");
  }
  if (*from > *to) fail("ends before it begins; swap its ends");
  return {run, *from, *to};
}

std::vector<Mask> masks_of(const std::vector<Mask>& masks, const std::string& path) {
  std::vector<Mask> own;
  std::copy_if(masks.begin(), masks.end(), std::back_inserter(own),
               [&](const Mask& mask) { return names_file(mask.run, path); });
  return own;
}

std::vector<bool> covered(const std::vector<Mask>& masks, const std::vector<double>& time_s) {
  std::vector<bool> result(time_s.size());
  for (const Mask& mask : masks) {
    const auto from = std::lower_bound(time_s.begin(), time_s.end(), mask.from_s);
    const auto to = std::upper_bound(from, time_s.end(), mask.to_s);
    std::fill(result.begin() + (from - time_s.begin()), result.begin() + (to - time_s.begin()),
              true);
  }
  return result;
}

double length_s(const std::vector<Mask>& masks) {
  double sum_s = 0;
  for (const Mask& mask : masks) sum_s += mask.to_s - mask.from_s;
  return sum_s;
}

void require_masked_runs(const std::vector<Mask>& masks, const std::vector<std::string>& runs) {
  require_runs("--mask", masks, runs);
}

Cut parse_cut(const std::string& text) {
  const auto [run, time] = run_and_times(text);
  const auto at_s = parse_number(time);
  if (!at_s) {
    throw InputError("--cut '" + text + "'",
                     "is not a time in seconds since power-on, as 3600, nor RUN:3600");
  }
  return {run, *at_s};
}

std::string cut_text(const Cut& cut) {
  return (cut.run.empty() ? "" : cut.run + ":") + format("%.10g", cut.at_s);
}

void require_cut_runs(const std::vector<Cut>& cuts, const std::vector<std::string>& runs) {
  require_runs("--cut", cuts, runs);
}

}  // namespace fogcomp::recording
