#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "findings/document.hpp"
#include "support/output_file.hpp"

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

/// Throws InputError if two of these commands, parsed, write the same file, other than the page of
/// their findings, or print JSON.
void require_own_outputs(const std::vector<CommandPointer>& commands);

/// What the commands of several axes find, together: a table and, with one --report for all, a
/// page. Does nothing for one axis, and for commands without --report.
class AxesReport {
 public:
  /// Opens the page. The commands, parsed, must not outlive it.
  AxesReport(const std::vector<AxisCall>& calls, const std::vector<CommandPointer>& commands);
  AxesReport(const AxesReport&) = delete;
  AxesReport& operator=(const AxesReport&) = delete;
  /// Prints the table and writes the page, once all commands have run.
  void finish();

 private:
  std::vector<std::string> axes_;
  std::string subject_;
  std::vector<findings::Document> documents_;
  std::optional<OutputFile> page_;
};

}  // namespace fogcomp::cli
