#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/signal/inputs.hpp"

namespace fogcomp::findings {

/// Text for the reader, in UTF-8, for a terminal and typeset for a page (deg/h becomes °/h, degC
/// °C, +- ±, `name` ‘name’). Only our own words are typeset; names from outside (files, serial
/// numbers, segments, expressions) are not. So a std::string does not convert implicitly: the
/// caller says which of the two it is.
class Text {
 public:
  Text() = default;
  Text(const char* literal);  ///< our own words
  Text& operator+=(const Text& more);

  const std::string& plain() const { return plain_; }
  const std::string& typeset() const { return typeset_; }
  bool empty() const { return plain_.empty(); }
  /// Typeset, with an initial capital (unless it begins with a name or an identifier such as
  /// thermal_lag) and a full stop.
  std::string sentence() const;

 private:
  friend Text verbatim(const std::string& name);
  friend Text words(std::string_view sentence, const std::vector<std::string>& names);
  std::string plain_;
  std::string typeset_;
  bool begins_with_name_ = false;
};
Text operator+(Text begin, const Text& end);

/// Our own words; `names` from outside within them are unchanged.
Text words(std::string_view sentence, const std::vector<std::string>& names = {});

/// A name from outside, unchanged.
Text verbatim(const std::string& name);

/// File names without folders, or full paths where two would be equal.
std::vector<std::string> short_names(const std::vector<std::string>& paths);

/// Four significant digits of a value in any unit; whole numbers unchanged.
Text significant(double value);

/// A rate in deg/h: four significant digits, no finer than the 1e-6 of a recording.
Text number(double rate_dph);
/// The same; "-" if there is none.
Text dph(const std::optional<double>& value);

/// "0.0424 +- 0.0067": a value and its standard deviation in the same unit, both to the second
/// digit of the latter. `sign`: "+" before a positive value.
std::string with_sigma(double value, double sigma, bool sign = false);

/// "12 %"
std::string percent(double share);

/// "input rate, °/h": an input with its unit, for an axis.
Text input_label(fog::Input input);
/// The same without the unit.
Text input_name(fog::Input input);

/// Text for the name of a variable, such as "temperature_rate".
Text variable_label(const std::string& variable);

/// Text with unit for a value of a batch, such as "holdout_drift_dph" or "warm_up.tau"; empty if
/// the name suffices.
Text figure_label(const std::string& figure);

}  // namespace fogcomp::findings
