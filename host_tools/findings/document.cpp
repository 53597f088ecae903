#include "findings/document.hpp"

#include <algorithm>
#include <iterator>

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

Parts::Parts(Sentence sentence) {
  if (!sentence.text.empty()) parts_.push_back({std::move(sentence)});
}

Parts::Parts(Heading heading) : parts_{{std::move(heading)}} {}
Parts::Parts(Listing listing) : parts_{{std::move(listing)}} {}
Parts::Parts(const Parts& other) = default;
Parts::Parts(Parts&& other) noexcept = default;
Parts& Parts::operator=(const Parts& other) = default;
Parts& Parts::operator=(Parts&& other) noexcept = default;
Parts::~Parts() = default;

Parts::Parts(Table table) {
  if (!table.rows.empty()) parts_.push_back({std::move(table)});
}

Parts::Parts(Plot plot) {
  if (!plot.curves.empty()) parts_.push_back({std::move(plot), Shown::on_page});
}

Parts& Parts::operator+=(Parts more) {
  parts_.insert(parts_.end(), std::make_move_iterator(more.parts_.begin()),
                std::make_move_iterator(more.parts_.end()));
  return *this;
}

Parts operator+(Parts begin, Parts end) {
  begin += std::move(end);
  return begin;
}

Parts show(Shown where, Parts parts) {
  for (Parts::Part& part : parts.parts_) part.shown = where;
  return parts;
}

Parts sentences(const std::vector<Text>& texts) {
  Parts all;
  for (const Text& text : texts) all += Sentence{text};
  return all;
}

Heading file_heading(const std::string& path, const Text& remark) {
  return {verbatim(short_names({path})[0]) + remark, path};
}

Next::Next(Text why, const std::vector<std::string>& words)
    : Next(std::move(why), shell_words(words)) {
  reads_recordings = words.size() > 1 && words[1] != "export";
}

void Document::read_with(const std::vector<std::string>& options) {
  if (next.reads_recordings && !options.empty()) next.command += " " + shell_words(options);
}

Parts Document::as_parts() const {
  Parts all = Sentence{found};
  for (const Lead& lead : leads) all += Sentence{words(lead.question + ": ") + lead.text};
  if (!next.sentence.empty() || !next.command.empty()) {
    all += Sentence{"next: " + next.sentence};
    if (!next.command.empty()) all += Listing{next.command};
  }
  return all + parts;
}

std::vector<Lead> without_empty(std::vector<Lead> leads) {
  const auto is_empty = [](const Lead& lead) { return lead.text.empty(); };
  leads.erase(std::remove_if(leads.begin(), leads.end(), is_empty), leads.end());
  return leads;
}

}  // namespace fogcomp::findings
