#pragma once

#include <stdexcept>
#include <string>

namespace fogcomp {

/// Bad arguments or bad input: what is wrong, where, and what to do, in one line. Ends the command
/// with exit code 2 and leaves every output as it was.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  /// `where` is a file, or `FILE:LINE`.
  InputError(const std::string& where, const std::string& what)
      : std::runtime_error(where + ": " + what) {}
};

}  // namespace fogcomp
