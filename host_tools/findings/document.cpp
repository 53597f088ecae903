#include "findings/document.hpp"

#include <algorithm>

#include "support/text.hpp"

namespace fogcomp::findings {

bool Table::has_bars() const {
  return std::any_of(columns.begin(), columns.end(),
                     [](const Column& column) { return !column.colour.empty(); });
}

bool Table::is_of_words(std::size_t column) const {
  constexpr std::size_t kLongestFigure = 24;
  return column > 0 && std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
           return column < row.cells.size() &&
                  row.cells[column].text.plain().size() > kLongestFigure;
         });
}

void Document::next(Text sentence, const std::vector<std::string>& command) {
  next_ = {std::move(sentence), shell_words(command)};
  proposes_reading_ = command.size() > 1 && command[1] != "export";
}

void Document::read_with(const std::vector<std::string>& options) {
  if (proposes_reading_ && !options.empty()) next_.command += " " + shell_words(options);
}

void Document::heading(Text text, Shown shown) {
  parts_.push_back({Heading{std::move(text)}, shown});
}

void Document::file_heading(const std::string& path, const Text& remark) {
  parts_.push_back({Heading{verbatim(short_names({path})[0]) + remark, path}});
}

void Document::sentence(Text text, Shown shown) {
  if (!text.empty()) parts_.push_back({Sentence{std::move(text)}, shown});
}

void Document::lead(std::string question, Text text) {
  if (!text.empty()) leads_.push_back({std::move(question), std::move(text)});
}

void Document::listing(std::string text, Shown shown) {
  parts_.push_back({Listing{std::move(text)}, shown});
}

void Document::table(Table table, Shown shown) {
  if (!table.rows.empty()) parts_.push_back({std::move(table), shown});
}

void Document::plot(Plot plot) {
  if (!plot.curves.empty()) parts_.push_back({std::move(plot), Shown::on_page});
}

void Document::append(const Document& other) {
  sentence(other.found_);
  for (const Lead& lead : other.leads_) sentence(words(lead.question + ": ") + lead.text);
  if (!other.next_.sentence.empty() || !other.next_.command.empty()) {
    sentence("next: " + other.next_.sentence);
    if (!other.next_.command.empty()) listing(other.next_.command);
  }
  parts_.insert(parts_.end(), other.parts_.begin(), other.parts_.end());
}

}  // namespace fogcomp::findings
