#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fogcomp {

/// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

/// Parts between separators, empty ones included; "" has no parts.
std::vector<std::string> split(std::string_view text, char separator);

/// Inverse of split(): the words with `separator` between them.
std::string join(const std::vector<std::string>& words, std::string_view separator);
/// For a sentence: "a, b or c", with `last` before the last word.
std::string join_list(const std::vector<std::string>& words, std::string_view last);

/// A word of a command that is proposed, for a shell: quoted if necessary. Standard input has been
/// read by then: "-" is FILE.
std::string shell_word(const std::string& word);
/// Such words, separated by blanks.
std::string shell_words(const std::vector<std::string>& words);

/// Removes white space at both ends.
std::string_view trim(std::string_view text);

/// The whole `text` as a finite number, else nothing.
std::optional<double> parse_number(std::string_view text);

/// A value in deg/h for the reader: four significant digits, no finer than the 1e-6 of a recording
/// (0.05432, 1.893, 1919); "-" if it is not finite.
std::string rounded(double value);
/// The same with sign, for an offset or a step: "+0.1860".
std::string signed_rounded(double value);

/// A time in the unit in which it is read most easily: "40 s", "7.2 min", "2.6 h".
std::string time_text(double seconds);

/// "1 row", "2 rows": `noun` in the singular, with a regular plural.
std::string counted(std::size_t count, const std::string& noun);

/// Length of the UTF-8 character at the start of `text`, 1 to 4; 0 if there is none.
std::size_t utf8_length(std::string_view text);

/// `text` with U+FFFD for each byte that is not UTF-8: for JSON and HTML.
std::string valid_utf8(std::string_view text);

/// Whether a terminal could execute a part of it: a control character, line ends and tabs included,
/// or a single byte 80 to 9F, which is one in other encodings.
bool has_control_character(std::string_view text);

/// Text that is safe on one line of a terminal: valid_utf8() with '?' for each match of
/// has_control_character().
std::string displayable(std::string_view text);

/// The candidate that `word` most probably means (Damerau-Levenshtein distance at most a third of
/// its length, at least 1; else the only one that begins with it), or "" if none is near.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// " (did you mean 'x'?)". Without a nearest() the candidates that `word` abbreviates part by part
/// (between '_'); "" if there are none or more than four.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// Bytes in base64 (RFC 4648), one line.
std::string base64(std::string_view bytes);

}  // namespace fogcomp
