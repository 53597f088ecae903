#include "cli/report_option.hpp"

#include <cstdio>

namespace fogcomp::cli {

Option report_option() {
  return {"report", "OUT.html", "the findings with plots, one page that opens offline", ""};
}

ReportFile::ReportFile(const Arguments& arguments) {
  if (arguments.has("report")) file_.emplace(arguments.text("report"));
}

void ReportFile::fill(const report::Report& report) {
  file_->write(report.html());
  file_->flush();
}

void ReportFile::commit() {
  if (!file_) return;
  file_->commit();
  std::fprintf(stderr, "report: %s\n", file_->path().c_str());
}

void ReportFile::write(const report::Report& report) {
  fill(report);
  commit();
}

}  // namespace fogcomp::cli
