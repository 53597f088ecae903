#pragma once

#include <optional>
#include <vector>

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
  /// Of a call for several axes: where the findings go, and whether all axes have one page.
  std::vector<findings::Document>* axes = nullptr;
  bool is_shared = false;
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
  /// Keeps the findings for the table and the page of several axes.
  void keep(const findings::Document& document) const;
  void write(const findings::Document& document,
             const std::optional<report::WorkbenchSetup>& bench = std::nullopt);

 private:
  std::optional<OutputFile> file_;
  std::vector<findings::Document>* axes_;
};

}  // namespace fogcomp::cli
