#include "report/report.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "findings/text.hpp"
#include "support/text.hpp"

namespace fogcomp::report {
namespace {

using findings::Document;
using findings::Heading;
using findings::Listing;
using findings::Plot;
using findings::Sentence;
using findings::Shown;
using findings::Table;

constexpr std::size_t kMaxLine = 100;  // characters
constexpr std::size_t kMaxName = 60;   // a longer name has a line of its own

// Characters of a UTF-8 text.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
  }));
}

// `text` padded to `width`: words to the left, figures to the right.
std::string cell(const std::string& text, std::size_t width, bool words) {
  const std::string blanks(width - std::min(width, width_of(text)), ' ');
  return words ? text + blanks : blanks + text;
}

std::string without_blanks_at_end(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

// Breaks `text` between words into lines of at most kMaxLine characters.
std::string wrapped(const std::string& text, const std::string& first, const std::string& others) {
  std::string lines;
  std::string line = first;
  bool is_begun = false;
  for (const std::string& word : split(text, ' ')) {
    if (is_begun && width_of(line) + 1 + width_of(word) > kMaxLine) {
      lines += line + "\n";
      line = others;
      is_begun = false;
    }
    line += (is_begun ? " " : "") + word;
    is_begun = true;
  }
  return lines + line + "\n";
}

// Whether `text` is a number or a range of two, perhaps with "%", and has no words after it.
bool is_figure(const std::string& text) {
  if (std::string_view("+-.0123456789").find(text[0]) == std::string_view::npos) return false;
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i - 1] == ' ' && std::isalpha(static_cast<unsigned char>(text[i])) != 0) return false;
  }
  return true;
}

// Whether a column is aligned as words: the first one, and those with more words than figures.
bool has_words(const Table& table, std::size_t column) {
  std::ptrdiff_t words = 0;
  for (const Table::Row& row : table.rows) {
    if (column >= row.cells.size() || row.cells[column].text.empty()) continue;
    words += is_figure(row.cells[column].text.plain()) ? -1 : 1;
  }
  return column == 0 || words > 0;
}

struct ColumnLayout {
  std::size_t width = 0;
  bool words = false;
};

ColumnLayout layout_of(const Table& table, std::size_t column) {
  ColumnLayout layout;
  layout.width = width_of(table.columns[column].title.plain());
  layout.words = has_words(table, column);
  for (const Table::Row& row : table.rows) {
    if (row.minor || column >= row.cells.size()) continue;
    const std::size_t width = width_of(row.cells[column].text.plain());
    if (column > 0 || width <= kMaxName) layout.width = std::max(layout.width, width);
  }
  return layout;
}

// One line of a table, each cell padded to its column.
std::string line_of(const std::vector<std::string>& cells,
                    const std::vector<ColumnLayout>& columns) {
  std::string line = "  ";
  for (std::size_t i = 0; i < std::min(cells.size(), columns.size()); ++i) {
    if (i > 0) line += "  ";
    line += cell(cells[i], columns[i].width, columns[i].words);
    if (i == 0 && width_of(cells[0]) > columns[0].width) {
      line += "\n  " + std::string(columns[0].width, ' ');
    }
  }
  return without_blanks_at_end(line);
}

std::string text_of(const Table& table) {
  std::vector<ColumnLayout> columns;
  std::vector<std::string> titles;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    columns.push_back(layout_of(table, i));
    titles.push_back(table.columns[i].title.plain());
  }
  std::string text;
  std::string caption = table.caption.plain();
  if (table.floor > 0) caption += "; the noise floor is " + findings::number(table.floor).plain();
  if (!caption.empty()) text += wrapped(caption, "  ", "  ");
  text += line_of(titles, columns);
  for (const Table::Row& row : table.rows) {
    if (row.minor) continue;
    std::vector<std::string> cells;
    for (const Table::Cell& one : row.cells) cells.push_back(one.text.plain());
    text += line_of(cells, columns);
  }
  if (!table.notes.empty()) text += wrapped("(" + table.notes.plain() + ")", "  ", "  ");
  return text;
}

// Collects the parts as text, with a blank line around listings and tables.
class TerminalWriter {
 public:
  explicit TerminalWriter(bool details) : details_(details) {}

  void operator()(const Heading& heading) {
    heading_ = heading.path.empty() ? heading.text.plain() : heading.path;
  }
  void operator()(const Sentence& sentence) {
    begin(false);
    text_ += wrapped(sentence.text.plain(), "  ", "    ");
  }
  void operator()(const Listing& listing) {
    begin(true);
    text_ += listing.text + (listing.text.empty() || listing.text.back() != '\n' ? "\n" : "");
  }
  void operator()(const Table& table) {
    begin(true);
    text_ += text_of(table);
  }
  void operator()(const Plot&) {}

  void write(const findings::Parts::Part& part) {
    const bool shown =
        part.shown == Shown::everywhere || (details_ && part.shown != Shown::on_page);
    if (shown) std::visit(*this, part.content);
  }
  const std::string& text() const { return text_; }

 private:
  // Writes the last heading, or a blank line. A heading that no part follows is not written.
  void begin(bool block) {
    if (!heading_.empty()) {
      text_ += "\n" + heading_ + "\n";
      heading_.clear();
    } else if (block || after_block_) {
      text_ += "\n";
    }
    after_block_ = block;
  }

  bool details_;
  bool after_block_ = false;
  std::string heading_;
  std::string text_;
};

}  // namespace

std::string terminal(const Document& document, bool details) {
  std::string text = wrapped(document.found.plain(), "", "    ");
  for (const findings::Lead& lead : document.leads) {
    text += wrapped(lead.question + ": " + lead.text.plain(), "  ", "    ");
  }
  const findings::Next& next = document.next;
  // A command stays in one line, to be copied.
  if (!next.command.empty()) {
    text += "  next: " + next.command + "\n";
  } else if (!next.sentence.empty()) {
    text += wrapped("next: " + next.sentence.plain(), "  ", "    ");
  }
  TerminalWriter writer(details);
  for (const findings::Parts::Part& part : document.parts) writer.write(part);
  const auto waits = [&](const findings::Parts::Part& part) {
    return part.shown == Shown::on_request;
  };
  const bool has_more = std::any_of(document.parts.begin(), document.parts.end(), waits);
  return text + writer.text() + (has_more && !details ? "  more: --details\n" : "");
}

}  // namespace fogcomp::report
