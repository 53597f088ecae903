#pragma once

#include <functional>
#include <string>
#include <vector>

#include "case_result.hpp"

namespace fogcomp::bench {

/// One line of the table: a value, its number of cases, and its target.
struct Measure {
  std::string key;   ///< of the JSON
  std::string what;  ///< description
  double value = 0;
  std::size_t cases = 0;  ///< 0: nothing to measure
  bool share = false;     ///< a fraction of the cases, which has an interval
  double target = 0;
  enum class Sense { at_least, at_most, none } sense = Sense::none;

  /// "yes", "no", or "" without a target or without cases.
  std::string reached() const;
  /// 95 % interval of a share (Wilson 1927).
  double low() const;
  double high() const;
};

using CaseTest = std::function<bool(const CaseResult&)>;

/// Fraction of the cases in `among` for which `holds`.
Measure share(std::string key, std::string what, const std::vector<CaseResult>& results,
              const CaseTest& among, const CaseTest& holds);
/// Quantile `part` of values, one per case.
Measure quantile_of(std::string key, std::string what, const std::vector<double>& values,
                    double part);
Measure with_target(Measure measure, Measure::Sense sense, double target);
/// Number of cases with a failed command: target none.
Measure failures(const std::vector<CaseResult>& results);

bool names_something(const CaseResult& result);
bool gives_single_name(const CaseResult& result);
/// The verdict is missing_effect, and the name is that of the hidden effect.
bool right_single_name(const CaseResult& result);

}  // namespace fogcomp::bench
