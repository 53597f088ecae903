#include "recording/mask.hpp"

#include <algorithm>
#include <iterator>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {

bool names_file(const std::string& run, const std::string& path) {
  return run.empty() || run == path || run == path.substr(path.rfind('/') + 1);
}

namespace {

// Throws InputError if the run of an option is none of the files.
void require_file_of(const char* option, const std::string& run,
                     const std::vector<std::string>& files) {
  const bool known = std::any_of(files.begin(), files.end(),
                                 [&](const std::string& file) { return names_file(run, file); });
  if (!known) throw InputError(option, "names " + run + ", which is none of the runs");
}

}  // namespace

Mask parse_mask(const std::string& text) {
  const auto fail = [&](const std::string& what) {
    throw InputError("--mask '" + text + "'", what);
  };
  const std::size_t colon = text.rfind(':');
  const std::string times = colon == std::string::npos ? text : text.substr(colon + 1);
  const std::size_t dots = times.find("..");
  const auto number = [&](std::size_t first, std::size_t count) {
    return parse_number(std::string_view(times).substr(first, count));
  };
  const auto from = number(0, dots == std::string::npos ? 0 : dots);
  const auto to = number(dots == std::string::npos ? times.size() : dots + 2, times.size());
  if (!from || !to) {
    fail("is not FROM..TO in seconds since power-on, as 3600..7200, nor RUN:FROM..TO");
  }
  if (*from > *to) fail("ends before it begins; swap its ends");
  return {colon == std::string::npos ? "" : text.substr(0, colon), *from, *to};
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
  for (const Mask& mask : masks) require_file_of("--mask", mask.run, runs);
}

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
