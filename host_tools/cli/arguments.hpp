#pragma once

#include <string>
#include <vector>

#include "cli/command.hpp"

namespace fogcomp::cli {

/// Hands the words after `fogcomp COMMAND` to the command's options and positionals. Throws
/// InputError for an unknown option (naming the nearest) or a missing value; for all of: the wrong
/// number or order of positionals, options that must be given, inputs that are not there beside
/// such a fault; for an output that is one of the inputs, two outputs that are one file, or a file
/// with a control character in its name.
/// Options may stand anywhere; `--name=value` and `--name value` both work.
void parse(Command& command, const std::vector<std::string>& words);

/// For a file that the command writes without an option that names it: throws InputError where
/// `path` is one of the inputs or of the outputs.
void check_output(const Command& command, const std::string& path);

}  // namespace fogcomp::cli
