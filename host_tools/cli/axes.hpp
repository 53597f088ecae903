#pragma once

#include <string>
#include <vector>

#include "cli/command.hpp"

namespace fogcomp::cli {

/// A call for several axes is one for each: `--rate-column x,y,z -o gyro_%.model`.
struct AxisCall {
  std::string axis;                ///< "" in a call for one
  std::vector<std::string> words;  ///< after `fogcomp COMMAND`
};

/// The calls that `words` stand for. In each, --rate-column is one of the names, and '%' in any
/// other word is that name as a part of a file's name: without unit, and with '_' for what is no
/// letter or digit.
std::vector<AxisCall> axis_calls(const std::vector<std::string>& words);

/// Throws InputError if two of these commands, parsed, write the same file or print JSON.
void require_own_outputs(const std::vector<CommandPointer>& commands);

}  // namespace fogcomp::cli
