#pragma once

#include <string>
#include <vector>

namespace fogcomp::bench {

/// A text of lines "KEY word word ...": the data format between the stages.
class KeyValues {
 public:
  /// Throws InputError for a file that cannot be read.
  explicit KeyValues(const std::string& path);

  /// The words after each line's `key`, in the order of the file.
  std::vector<std::vector<std::string>> all(const std::string& key) const;
  /// First word after the only line with `key`; "" if there is none.
  std::string word(const std::string& key) const;
  /// The same as a number; throws InputError if there is none.
  double number(const std::string& key) const;

 private:
  std::string path_;
  std::vector<std::vector<std::string>> lines_;
};

}  // namespace fogcomp::bench
