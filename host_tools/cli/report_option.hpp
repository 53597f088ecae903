#pragma once

#include <optional>

#include "cli/option.hpp"
#include "findings/document.hpp"
#include "report/workbench_page.hpp"
#include "support/output_file.hpp"

namespace fogcomp::cli {

/// --report
struct ReportOption : Text {
  explicit ReportOption(OptionGroup* group)
      : Text(group,
             {"report", "OUT.html", "the findings with plots, one page that opens offline"}) {}
};

/// The page of --report, opened before the work begins, so that an unwritable folder is reported at
/// once. Without the option it does nothing.
class ReportFile {
 public:
  explicit ReportFile(const ReportOption& option);
  bool wanted() const { return file_.has_value(); }
  /// The page, on which `bench` calculates; it gets its name with the command's other output, or by
  /// write() alone.
  void fill(const findings::Document& document,
            const std::optional<report::WorkbenchSetup>& bench = std::nullopt);
  void commit();
  void write(const findings::Document& document,
             const std::optional<report::WorkbenchSetup>& bench = std::nullopt);

 private:
  std::optional<OutputFile> file_;
};

}  // namespace fogcomp::cli
