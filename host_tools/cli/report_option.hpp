#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "cli/option.hpp"
#include "findings/document.hpp"
#include "report/report.hpp"
#include "support/json.hpp"
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
  using Bench = std::function<std::optional<report::WorkbenchSetup>()>;

  explicit ReportFile(const ReportOption& option);
  /// The page, on which what `bench` gives calculates; it gets its name by commit(), with the
  /// command's other output. Also keeps the findings for the table and the page of several axes.
  void fill(const findings::Document& document, const Bench& bench = {});
  void commit();

 private:
  std::optional<OutputFile> file_;
  std::vector<findings::Document>* axes_;
};

/// Prints what a command has found: what `object` gives with --json, else `document` as text.
void print_found(const Flag& json, const std::function<Json()>& object,
                 const findings::Document& document, bool details = false);

}  // namespace fogcomp::cli
