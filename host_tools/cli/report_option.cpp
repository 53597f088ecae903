#include "cli/report_option.hpp"

#include <cstdio>

#include "report/report.hpp"

namespace fogcomp::cli {

ReportFile::ReportFile(const ReportOption& option) : axes_(option.axes) {
  if (option.given() && !option.is_shared) file_.emplace(option.value());
}

void ReportFile::fill(const findings::Document& document, const Bench& bench) {
  if (axes_ != nullptr) axes_->push_back(document);
  if (!file_) return;
  const std::optional<report::WorkbenchSetup> setup = bench ? bench() : std::nullopt;
  file_->write(report::page(document, setup ? &*setup : nullptr));
  file_->flush();
}

void ReportFile::commit() {
  if (!file_) return;
  file_->commit();
  std::fprintf(stderr, "report: %s\n", file_->path().c_str());
}

void print_found(const Flag& json, const std::function<Json()>& object,
                 const findings::Document& document, bool details) {
  const std::string text =
      json.given() ? object().text() + "\n" : report::terminal(document, details);
  std::fputs(text.c_str(), stdout);
}

}  // namespace fogcomp::cli
