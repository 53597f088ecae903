#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/csv_layout.hpp"
#include "support/input_error.hpp"

namespace fogcomp::recording {

/// The refusal if the numbers of a column that is read have three digits behind their mark,
/// all of them, and no number of the file tells what the mark is: "12,389" is 12.389 or 12389. A
/// point between columns that commas or blanks separate is the decimal point of programs, and no
/// question but for counts, which are whole. `lines`: the first ones of the file.
std::optional<InputError> refusal_of_marks(const std::vector<std::string_view>& lines,
                                           const std::string& path, const CsvLayout& layout);

}  // namespace fogcomp::recording
