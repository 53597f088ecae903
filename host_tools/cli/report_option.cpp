#include "cli/report_option.hpp"

#include <cstdio>

#include "report/page.hpp"

namespace fogcomp::cli {

ReportFile::ReportFile(const ReportOption& option) : axes_(option.axes) {
  if (option.given() && !option.is_shared) file_.emplace(option.value());
}

void ReportFile::keep(const findings::Document& document) const {
  if (axes_ != nullptr) axes_->push_back(document);
}

void ReportFile::fill(const findings::Document& document,
                      const std::optional<report::WorkbenchSetup>& bench) {
  file_->write(report::page(document, bench ? &*bench : nullptr));
  file_->flush();
}

void ReportFile::commit() {
  if (!file_) return;
  file_->commit();
  std::fprintf(stderr, "report: %s\n", file_->path().c_str());
}

void ReportFile::write(const findings::Document& document,
                       const std::optional<report::WorkbenchSetup>& bench) {
  fill(document, bench);
  commit();
}

}  // namespace fogcomp::cli
