#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fogcomp {

/// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

/// Parts between separators, empty ones included; "" gives no part.
std::vector<std::string> split(std::string_view text, char separator);

/// What split() takes apart: the words with `separator` between them.
std::string join(const std::vector<std::string>& words, std::string_view separator);

/// Without white space at both ends.
std::string_view trim(std::string_view text);

/// The whole of `text` as a finite number, else nothing.
std::optional<double> parse_number(std::string_view text);

/// The candidate that `word` most likely means (Damerau-Levenshtein distance at most a third of its
/// length, at least 1; else the only one that begins with it), or "" where none is near.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// " (did you mean 'x'?)", or "" where no candidate is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace fogcomp
