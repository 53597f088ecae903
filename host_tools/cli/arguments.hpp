#pragma once

#include <string>
#include <vector>

#include "cli/command.hpp"

namespace fogcomp::cli {

/// Assigns the words after `fogcomp COMMAND` to the command's options and positionals. Throws
/// InputError for an unknown option (with the nearest one), a missing value, a wrong number or
/// order of positionals, a missing required option (together with missing inputs), an output that
/// is also an input, two outputs with one file, and a file name with a control character. Options
/// may be anywhere; `--name=value` and `--name value` both work.
void parse(Command& command, const std::vector<std::string>& words);

/// For an output that no option names: throws InputError if `path` is one of the inputs or outputs.
void check_output(const Command& command, const std::string& path);

}  // namespace fogcomp::cli
