#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "recording/csv_layout.hpp"

namespace fogcomp::recording {

/// Finds out how the times of a file are written, and sets the layout's format and, if its name has
/// no unit, that of the column: the only one that gives a possible date or period
/// (time_scale.hpp). `lines`: the first ones of the file. Throws InputError for times of no known
/// form and for those that can mean several things, with the --columns that says which.
void understand_times(const std::vector<std::string_view>& lines, const std::string& path,
                      CsvLayout& layout);

}  // namespace fogcomp::recording
