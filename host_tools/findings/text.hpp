#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fogcomp::findings {

/// What a reader sees, in UTF-8, for a terminal and typeset for a page (deg/h is °/h there, degC
/// °C, +- ±). Only words of ours are typeset; names from outside (files, serial numbers, segments,
/// expressions) never are. A std::string does not convert: whoever has one says which of the two
/// it is.
class Text {
 public:
  Text() = default;
  Text(const char* literal);  ///< ours
  Text& operator+=(const Text& more);

  const std::string& plain() const { return plain_; }
  const std::string& typeset() const { return typeset_; }
  bool empty() const { return plain_.empty(); }
  /// Typeset, with a capital at its beginning, unless a name stands there, and a full stop.
  std::string sentence() const;

 private:
  friend Text verbatim(const std::string& name);
  friend Text words(std::string_view sentence, const std::vector<std::string>& names);
  std::string plain_;
  std::string typeset_;
  bool begins_with_name_ = false;
};
Text operator+(Text begin, const Text& end);

/// Words of ours. `names` from outside that are part of them stay as they are.
Text words(std::string_view sentence, const std::vector<std::string>& names = {});

/// A name from outside, as it is.
Text verbatim(const std::string& name);

/// The names of files without their folders, or whole where two would have the same.
std::vector<std::string> short_names(const std::vector<std::string>& paths);

}  // namespace fogcomp::findings
