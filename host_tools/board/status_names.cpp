#include "board/status_names.hpp"

#include <algorithm>
#include <iterator>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::board {
namespace {

// In the order of the bits (firmware/SPEC.md, "Status flags").
constexpr const char* kFlagNames[] = {
    "gyro_invalid",        "rate_out_of_range",   "gyro_stuck",       "sequence_gap",
    "temperature_invalid", "temperature_clamped", "drift_held",       "drift_given_up",
    "thermal_settling",    "denoiser_filling",    "model_refused",    "denoised_invalid",
    "input_missing",       "rate_jump",           "temperature_jump", "temperature_frozen",
    "self_test_failed",    "sample_rate",         "history_unknown",  "drift_outdated",
    "rate_refused",        "denoised_refused",    "no_samples"};

fog::Status flag(std::size_t bit) {
  return static_cast<fog::Status>(1U << bit);
}

}  // namespace

std::vector<std::string> flag_names(fog::Status status) {
  std::vector<std::string> names;
  for (std::size_t bit = 0; bit < std::size(kFlagNames); ++bit) {
    if (has_any(status, flag(bit))) names.emplace_back(kFlagNames[bit]);
  }
  return names;
}

fog::Status parse_flags(const std::string& list, fog::Status allowed, const std::string& who) {
  fog::Status flags = fog::Status::none;
  if (list == "none") return flags;
  for (const std::string& name : split(list, ',')) {
    const auto found = std::find(std::begin(kFlagNames), std::end(kFlagNames), name);
    const auto bit = static_cast<std::size_t>(found - std::begin(kFlagNames));
    if (found == std::end(kFlagNames) || !has_any(allowed, flag(bit))) {
      throw InputError(who, "'" + name + "' is none of " + join(flag_names(allowed), ", ") +
                                "; write some of them with commas between, or none");
    }
    flags |= flag(bit);
  }
  return flags;
}

}  // namespace fogcomp::board
