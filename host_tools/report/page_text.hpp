#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fogcomp::report {

/// What a reader sees, in UTF-8. Words of ours are typeset when the text is made (deg/h becomes
/// °/h, degC °C, +- ±); names from outside (files, serial numbers, segments, expressions) never
/// are. A std::string does not convert: whoever has one says which of the two it is.
class Text {
 public:
  Text() = default;
  Text(const char* literal);  ///< ours
  Text& operator+=(const Text& more);

  const std::string& utf8() const { return utf8_; }
  bool empty() const { return utf8_.empty(); }

 private:
  friend Text verbatim(std::string name);
  std::string utf8_;
};
Text operator+(Text begin, const Text& end);

/// Words of ours. `names` from outside that are part of them stay as they are.
Text words(std::string_view sentence, const std::vector<std::string>& names = {});

/// A name from outside, as it is.
Text verbatim(std::string name);

/// The names of files without their folders, or whole where two would have the same.
std::vector<std::string> short_names(const std::vector<std::string>& paths);

}  // namespace fogcomp::report
