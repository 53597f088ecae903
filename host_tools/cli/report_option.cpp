#include "cli/report_option.hpp"

#include <cstdio>

namespace fogcomp::cli {

ReportFile::ReportFile(const ReportOption& option) {
  if (option.given()) file_.emplace(option.value());
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
