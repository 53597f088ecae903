#pragma once

// std::to_chars and std::from_chars of double for the engine's library (libc++ 14), which has them
// for integers only. All digits equal those of the host's library, so that a page writes the same
// model files as the shell.

#include <charconv>

namespace fogcomp::workbench {

/// As std::to_chars(first, last, value): the shortest decimal that reads back to the same bits, of
/// those the closest, fixed where that is no longer than scientific. Returns the end.
char* print_shortest(char* first, double value);

/// As std::to_chars(first, last, value, std::chars_format::fixed, decimals).
char* print_fixed(char* first, char* last, double value, int decimals);

/// As std::from_chars(first, last, value), without "inf" and "nan".
std::from_chars_result scan(const char* first, const char* last, double& value);

}  // namespace fogcomp::workbench

#ifdef __EMSCRIPTEN__
namespace std {  // NOLINT: stands in for what the library lacks

inline to_chars_result to_chars(char* first, char*, double value) {
  return {fogcomp::workbench::print_shortest(first, value), errc()};
}
inline to_chars_result to_chars(char* first, char* last, double value, chars_format, int decimals) {
  return {fogcomp::workbench::print_fixed(first, last, value, decimals), errc()};
}
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  return fogcomp::workbench::scan(first, last, value);
}

}  // namespace std
#endif
