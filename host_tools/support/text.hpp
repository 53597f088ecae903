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
/// As in a sentence: "a, b or c", with `last` before the last one.
std::string join_list(const std::vector<std::string>& words, std::string_view last);

/// A word of a command line as a shell takes it: in quotes where it has to be.
std::string shell_word(const std::string& word);
/// Such words with blanks between them.
std::string shell_words(const std::vector<std::string>& words);

/// Without white space at both ends.
std::string_view trim(std::string_view text);

/// The whole of `text` as a finite number, else nothing.
std::optional<double> parse_number(std::string_view text);

/// A figure in deg/h as people read it: four significant digits, no finer than the 1e-6 that a
/// recording holds (0.05432, 1.893, 1919); "-" where it is not finite.
std::string rounded(double value);
/// The same with its sign, as an offset or a step has it: "+0.1860".
std::string signed_rounded(double value);

/// "1 row", "2 rows": `noun` in the singular, whose plural takes an s.
std::string counted(std::size_t count, const std::string& noun);

/// Bytes at the start of `text` that are one character of UTF-8, 1 to 4; 0 where there is none.
std::size_t utf8_length(std::string_view text);

/// `text` with U+FFFD for each byte that is no UTF-8: what JSON and HTML must be.
std::string valid_utf8(std::string_view text);

/// Whether something in it is a command to a terminal: a control character, line ends and tabs
/// included, or a bare byte of 80 to 9F, which is one where text is not taken for UTF-8.
bool has_control_character(std::string_view text);

/// What a terminal can show in one line without obeying it: valid_utf8() with '?' for each that
/// has_control_character() finds.
std::string displayable(std::string_view text);

/// The candidate that `word` most likely means (Damerau-Levenshtein distance at most a third of its
/// length, at least 1; else the only one that begins with it), or "" where none is near.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// " (did you mean 'x'?)"; where nearest() finds none, those of whose parts (between '_') each of
/// the word's begins one, in order; "" where there are none or more than four.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace fogcomp
