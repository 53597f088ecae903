#pragma once

#include <functional>
#include <string>
#include <vector>

#include "case_result.hpp"

namespace fogcomp::bench {

/// One line of the table: a figure, how many cases it comes from, and what is to be reached.
struct Measure {
  std::string key;   ///< of the JSON
  std::string what;  ///< in words
  double value = 0;
  std::size_t cases = 0;  ///< 0: there was nothing to measure
  bool share = false;     ///< a share of the cases, for which an interval can be given
  double target = 0;
  enum class Sense { at_least, at_most, none } sense = Sense::none;

  /// "yes", "no", or "" without a target or without cases.
  std::string reached() const;
  /// 95 % interval of a share (Wilson 1927).
  double low() const;
  double high() const;
};

using CaseTest = std::function<bool(const CaseResult&)>;

/// Share of the cases in `among` of which `holds`.
Measure share(std::string key, std::string what, const std::vector<CaseResult>& results,
              const CaseTest& among, const CaseTest& holds);
/// Of values, one per case, that which `part` of them do not exceed.
Measure quantile_of(std::string key, std::string what, const std::vector<double>& values,
                    double part);
Measure with_target(Measure measure, Measure::Sense sense, double target);
/// Cases in which some command ended with a failure: none.
Measure failures(const std::vector<CaseResult>& results);

bool names_something(const CaseResult& result);
bool gives_single_name(const CaseResult& result);
/// The verdict is missing_effect, and the name is what is hidden.
bool right_single_name(const CaseResult& result);

}  // namespace fogcomp::bench
