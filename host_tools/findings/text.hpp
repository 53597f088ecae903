#pragma once

#include <string>
#include <string_view>
#include <vector>

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

}  // namespace fogcomp::findings
