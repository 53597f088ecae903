#pragma once

#include <string>
#include <string_view>

namespace fogcomp::recording {

/// Name of the script in importers/ that reads a file with these first bytes ("mcap"); "" if none
/// does.
std::string importer_of(std::string_view head);

/// Throws InputError for a file of a common format that is neither text nor a sensor stream,
/// recognised by its first bytes, with the way to a CSV.
void refuse_foreign_format(std::string_view head, const std::string& path);

}  // namespace fogcomp::recording
