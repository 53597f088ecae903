#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "planning/expectation.hpp"

namespace fogcomp::planning {

/// One line of what an operator types into a chamber: a ramp and the soak after it.
struct Step {
  double to_degc = 0;
  double ramp_degc_per_min = 0;  ///< positive; 0: no ramp
  double soak_min = 0;
  double rate_dps = 0;  ///< of the rate table meanwhile

  /// How long ramp and soak take, min.
  double minutes(double from_degc) const;
};

struct Plan {
  double start_degc = 20;
  std::vector<Step> steps;
  Expectation expectation;
  std::vector<double> sigma_after_dph;  ///< in the box, after each step
};

/// A profile for `simulate --profile`.
std::string profile_text(const Plan& plan);
/// The same of its first steps.
std::string profile_text(const Plan& plan, std::size_t steps);

struct SearchSettings {
  OperatingBox chamber;
  double hours = 8;
  std::uint64_t seed = 1;
  std::function<void(double)> progress{};  ///< called with the fraction done; may be empty
};

/// The programme of `hours` with the smallest expected error in the box of use, among ramps between
/// nine temperatures of the box, at four speeds of the chamber, with soaks of five lengths: the
/// best of random ones, then one change after another that makes it better.
Plan search_plan(const Foresight& foresight, const SearchSettings& settings);

}  // namespace fogcomp::planning
