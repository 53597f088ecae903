#include "cli/axes.hpp"

#include <cctype>
#include <cstdio>

#include "cli/report_option.hpp"
#include "report/report.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

constexpr const char* kOption = "--rate-column";
constexpr const char* kReport = "report";

std::string part_of_file_name(const std::string& axis) {
  std::string part(trim(axis.substr(0, axis.find_first_of("[("))));
  for (char& c : part) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
  }
  return part;
}

std::string with_axis(std::string word, const std::string& part) {
  for (std::size_t at = word.find('%'); at != std::string::npos;
       at = word.find('%', at + part.size())) {
    word.replace(at, 1, part);
  }
  return word;
}

// The word that names the axes, and where in it they begin; its index is the number of words if
// there is none.
struct AxesWord {
  std::size_t index;
  std::size_t begin = 0;
};

AxesWord find_axes(const std::vector<std::string>& words) {
  const std::string joined = std::string(kOption) + "=";
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == kOption && i + 1 < words.size()) return {i + 1};
    if (words[i].rfind(joined, 0) == 0) return {i, joined.size()};
  }
  return {words.size()};
}

// Of the commands that have one.
std::vector<ReportOption*> report_options(const std::vector<CommandPointer>& commands) {
  std::vector<ReportOption*> options;
  for (const CommandPointer& command : commands) {
    auto* const option = dynamic_cast<ReportOption*>(command->find_option(kReport));
    if (option != nullptr) options.push_back(option);
  }
  return options;
}

// The axes side by side: what was found of each.
findings::Document table_of(const std::string& subject, const std::vector<std::string>& axes,
                            const std::vector<findings::Document>& documents) {
  findings::Table table;
  table.columns = {"axis", "found"};
  for (std::size_t i = 0; i < documents.size(); ++i) {
    table.rows.push_back({findings::verbatim(axes[i]), documents[i].found});
  }
  return {subject, findings::words(format("%zu axes", documents.size())), {}, {}, table};
}

}  // namespace

std::vector<AxisCall> axis_calls(const std::vector<std::string>& words) {
  const AxesWord found = find_axes(words);
  if (found.index == words.size()) return {{"", words}};
  const std::string text = words[found.index].substr(found.begin);
  if (text.find(',') == std::string::npos) return {{"", words}};
  std::vector<AxisCall> calls;
  for (const std::string& each : split(text, ',')) {
    const std::string axis(trim(each));
    if (axis.empty()) throw InputError(kOption, "'" + text + "' has an empty name; give x,y,z");
    AxisCall call{axis, {}};
    for (const std::string& word : words) {
      call.words.push_back(with_axis(word, part_of_file_name(axis)));
    }
    call.words[found.index] = words[found.index].substr(0, found.begin) + axis;
    calls.push_back(std::move(call));
  }
  return calls;
}

void require_own_outputs(const std::vector<CommandPointer>& commands) {
  if (commands.size() < 2) return;
  for (const Option* option : commands[0]->options()) {
    if (!option->given()) continue;
    if (option->name == "json")
      throw InputError("--json", "is of one axis; give one --rate-column");
    if (value_use(*option) != ValueUse::output || option->name == kReport) continue;
    for (std::size_t i = 1; i < commands.size(); ++i) {
      if (commands[i]->find_option(option->name)->text() !=
          commands[i - 1]->find_option(option->name)->text()) {
        continue;
      }
      throw InputError(option->text(),
                       "would be written for each axis; put % where its name belongs");
    }
  }
}

AxesReport::AxesReport(const std::vector<AxisCall>& calls,
                       const std::vector<CommandPointer>& commands) {
  const std::vector<ReportOption*> options = report_options(commands);
  if (calls.size() < 2 || options.size() < calls.size()) return;
  for (const AxisCall& call : calls) axes_.push_back(call.axis);
  subject_ = "fogcomp " + commands[0]->name() + " " + join(commands[0]->arguments, " ") + " " +
             kOption + " " + join(axes_, ",");
  const bool is_shared = options[0]->given() && options[0]->text() == options[1]->text();
  if (is_shared) page_.emplace(options[0]->text());
  for (ReportOption* option : options) {
    option->axes = &documents_;
    option->is_shared = is_shared;
  }
}

void AxesReport::finish() {
  if (axes_.empty()) return;
  findings::Document document = table_of(subject_, axes_, documents_);
  std::printf("\n%s", report::terminal(document).c_str());
  if (!page_) return;
  for (std::size_t i = 0; i < documents_.size(); ++i) {
    document.parts += findings::Heading{findings::verbatim(axes_[i])} + documents_[i].as_parts();
  }
  page_->write(report::page(document));
  page_->commit();
  std::fprintf(stderr, "report: %s\n", page_->path().c_str());
}

}  // namespace fogcomp::cli
