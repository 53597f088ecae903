#include "report/report.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "findings/text.hpp"
#include "report/embedded_page.hpp"
#include "report/html.hpp"
#include "report/plots.hpp"
#include "support/input_error.hpp"
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
using findings::Text;

std::string element(const char* tag, const std::string& content) {
  return format("<%s>%s</%s>\n", tag, content.c_str(), tag);
}

// "left:12.3%": `value` as a share of `max`, as a CSS length.
std::string share_style(const char* property, double value, double max) {
  const double share = max > 0 ? std::clamp(value / max, 0.0, 1.0) : 0;
  return format("%s:%.1f%%", property, 100 * share);
}

// The content of a row's first cell, its name. An identifier may break after each underscore.
std::string name_element(const Text& name, const std::string& link) {
  std::string content;
  for (const char letter : escaped(name)) {
    content += letter;
    if (letter == '_') content += "<wbr>";
  }
  return link.empty() ? content : "<a href=\"" + escaped(link) + "\">" + content + "</a>";
}

std::string row_element(const Table& table, const Table::Row& row) {
  std::string html = "<tr>";
  for (std::size_t column = 0; column < row.cells.size(); ++column) {
    const char* const tag = column == 0 ? "th" : "td";
    const Text& text = row.cells[column].text;
    const std::string content = column == 0 ? name_element(text, row.link) : escaped(text);
    html += format("<%s%s>%s</%s>", tag, table.is_of_words(column) ? " class=\"words\"" : "",
                   content.c_str(), tag);
  }
  return html + "</tr>\n";
}

std::string head_element(const Table& table) {
  std::string html = "<thead><tr>";
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    html += format("<th%s>%s</th>", table.is_of_words(column) ? " class=\"words\"" : "",
                   escaped(table.columns[column].title).c_str());
  }
  return html + "</tr></thead>\n";
}

std::string table_element(const Table& table) {
  std::string html;
  if (!table.caption.empty()) html += element("p", escaped(table.caption.sentence()));
  // Scrolls sideways where the window is too narrow; tabindex: by the keyboard too.
  html += "<div class=\"scroll\" tabindex=\"0\"><table>\n" + head_element(table) + "<tbody>\n";
  for (const Table::Row& row : table.rows) html += row_element(table, row);
  html += "</tbody></table></div>\n";
  if (!table.notes.empty()) html += element("p", escaped(table.notes.sentence()));
  return html;
}

// The value whose bar takes the whole width.
double full_length(const Table& table) {
  double full = std::max(table.full, table.floor);
  for (const Table::Row& row : table.rows) {
    for (const Table::Cell& cell : row.cells) {
      if (std::isfinite(cell.value)) full = std::max(full, cell.value);
    }
  }
  return full;
}

std::string bar_element(const Table::Cell& cell, const std::string& colour, double full,
                        double floor) {
  std::string html = "<div class=\"bar\"><span class=\"track\"><span class=\"fill\" style=\"" +
                     share_style("width", cell.value, full) + ";background:var(--" + colour +
                     ")\"></span>";
  if (floor > 0) {
    html += "<span class=\"mark\" style=\"" + share_style("left", floor, full) + "\"></span>";
  }
  return html + "</span><span class=\"value\">" + escaped(cell.text) + "</span></div>";
}

// The axis below the bars: from 0 to `full`, and its quantity with the unit.
std::string axis_element(const Text& quantity, double full) {
  return "<div class=\"row axis\"><div></div><div class=\"bar\"><span "
         "class=\"scale\"><span>0</span>"
         "<span class=\"quantity\">" +
         escaped(quantity) + "</span><span>" + escaped(findings::significant(full)) +
         "</span></span><span class=\"value\"></span></div></div>\n";
}

// The legend of the colours, if there are several, and of the dashed line.
std::string key_elements(const Table& table) {
  std::vector<Table::Column> keys = table.keys;
  if (keys.empty()) {
    std::copy_if(table.columns.begin(), table.columns.end(), std::back_inserter(keys),
                 [](const Table::Column& column) { return !column.colour.empty(); });
  }
  if (keys.size() == 1) keys.clear();
  std::string html;
  for (const Table::Column& key : keys) {
    html += " <span class=\"keyed\"><span class=\"key\" style=\"background:var(--" + key.colour +
            ")\"></span> " + escaped(key.title) + "</span>";
  }
  if (table.floor > 0) {
    html += (keys.empty() ? " Dashed" : "; dashed") + std::string(": the noise floor, ") +
            escaped(findings::number(table.floor)) + ".";
  }
  return html;
}

// A row with bars: its name, the bars one below the other, and the other columns as a note.
std::string bars_row_element(const Table& table, const Table::Row& row, double full) {
  std::string bars;
  std::string note;
  for (std::size_t column = 1; column < row.cells.size(); ++column) {
    const Table::Cell& cell = row.cells[column];
    const std::string& colour = table.columns[column].colour;
    if (!colour.empty()) {
      if (std::isfinite(cell.value)) {
        bars += bar_element(cell, row.colour.empty() ? colour : row.colour, full, table.floor);
      }
    } else if (!cell.text.empty()) {
      const Text& title = table.columns[column].title;
      note += (note.empty() ? "" : "; ") + escaped(title) + (title.empty() ? "" : " ") +
              escaped(cell.text);
    }
  }
  std::string html = "<div class=\"row\"><div class=\"name\">" + escaped(row.cells[0].text) +
                     "</div><div>" + bars + "</div>";
  if (!note.empty()) html += "<div class=\"note\">" + note + "</div>";
  return html + "</div>\n";
}

std::string bars_element(const Table& table) {
  const double full = full_length(table);
  const auto bars =
      std::count_if(table.columns.begin(), table.columns.end(),
                    [](const Table::Column& column) { return !column.colour.empty(); });
  const bool notes = static_cast<std::size_t>(bars) + 1 < table.columns.size();
  std::string html = format("<figure class=\"bars%s\">\n", notes ? " notes" : "");
  const std::string caption = escaped(table.caption.sentence()) + key_elements(table);
  if (!caption.empty()) html += element("figcaption", caption);
  for (const Table::Row& row : table.rows) html += bars_row_element(table, row, full);
  html += axis_element(table.quantity, full) + "</figure>\n";
  if (!table.notes.empty()) html += element("p", escaped(table.notes.sentence()));
  return html;
}

// Footer of every report with plots: how to operate and how to read them.
constexpr const char* kHowToRead =
    "Drag across a plot to zoom in time or in both directions, double-click to see all again; "
    "click on a name in a legend to hide or show its curve. Shaded: red while the chamber heats, "
    "blue while it cools. Heating and cooling in plots over another quantity: the direction in "
    "which the temperature last moved; soaks count with the ramp before them. A curve of more than "
    "4000 rows is drawn by the minimum and maximum of each of 2000 intervals; a point of a cloud "
    "of more than 2000 rows is the mean of neighbouring rows.";

// Collects the document's parts as HTML (body) and the data of its plots as JSON (plots).
// `draws`: whether the plot library is there; without it plots are only counted.
class PageWriter {
 public:
  explicit PageWriter(bool draws) : draws_(draws) {}

  void operator()(const Heading& heading) { heading_ = &heading; }
  void operator()(const Sentence& sentence) {
    begin();
    body_ += element("p", escaped(sentence.text.sentence()));
  }
  void operator()(const Listing& listing) {
    begin();
    body_ += element("pre", escaped(listing.text));
  }
  void operator()(const Table& table) {
    begin();
    body_ += table.has_bars() ? bars_element(table) : table_element(table);
  }
  void operator()(const Plot& plot) {
    const std::size_t number = plot_count_++;
    if (!draws_) return;
    begin();
    const std::string title = escaped(plot.title.sentence());
    const std::string caption = escaped(plot.caption);
    body_ +=
        format("<figure class=\"plot%s\">\n", plot.is_small ? " small" : "") +
        element("figcaption", "<strong>" + title + "</strong> " + caption) +
        format("<div class=\"canvas\" data-plot=\"%zu\" role=\"img\" aria-label=\"%s\"></div>\n",
               number, (title + " " + caption).c_str()) +
        "<noscript>" + plot_svg(plot) + "</noscript></figure>\n";
    plots_.push(plot_json(plot));
  }
  void write(const Document& document) {
    for (const findings::Lead& lead : document.leads) {
      body_ += element("p", "<strong>" + escaped(findings::words(lead.question).sentence()) +
                                "</strong> " + escaped(lead.text.sentence()));
    }
    const findings::Next& next = document.next;
    if (!next.sentence.empty()) {
      body_ += "<p class=\"next\"><strong>Next:</strong> " + escaped(next.sentence.sentence()) +
               "</p>\n";
    }
    if (!next.command.empty())
      body_ += "<pre class=\"command\">" + escaped(next.command) + "</pre>\n";
    for (const findings::Parts::Part& part : document.parts) {
      if (part.shown != Shown::in_details) std::visit(*this, part.content);
    }
    if (in_section_) body_ += "</section>\n";
  }

  const std::string& body() const { return body_; }
  const Json& plots() const { return plots_; }
  std::size_t plot_count() const { return plot_count_; }

 private:
  // Opens a section with the last heading. A heading that no part follows is not written.
  void begin() {
    if (heading_ == nullptr) return;
    body_ += in_section_ ? "</section>\n<section>\n" : "<section>\n";
    in_section_ = true;
    body_ += element("h2", escaped(heading_->text));
    const std::string& path = heading_->path;
    if (!path.empty() && findings::short_names({path})[0] != path) {
      body_ += "<p class=\"path\">" + escaped(path) + "</p>\n";
    }
    heading_ = nullptr;
  }

  bool draws_;
  const Heading* heading_ = nullptr;
  bool in_section_ = false;
  std::string body_;
  Json plots_ = Json::array();
  std::size_t plot_count_ = 0;
};

}  // namespace

std::string page(const Document& document, const WorkbenchSetup* bench) {
  const bool drawn = !plot_library_files().empty();
  PageWriter writer(drawn);
  writer.write(document);
  std::string body = "<p class=\"subject\">" + escaped(document.subject) + "</p>\n";
  body += element("h1", escaped(document.found.sentence()));
  if (!drawn && writer.plot_count() > 0) {
    body += element(
        "p", "No plots here: this fogcomp was built without npm. Install npm and build it again.");
  }
  body += writer.body();
  if (drawn && writer.plot_count() > 0) body += element("footer", escaped(Text(kHowToRead)));
  return framed({document.subject, "<main id=\"report\">\n" + body + "</main>\n", writer.plots(),
                 writer.plot_count() > 0, bench});
}

std::string why_no_workbench() {
  if (embedded_engine().module.empty()) {
    return "this fogcomp was built without its engine for pages: host_tools/quickstart.sh --page "
           "builds it";
  }
  if (plot_library_files().empty()) {
    return "this fogcomp was built without its plot library: install npm and build it again";
  }
  return "";
}

std::string workbench_page(const WorkbenchSetup& setup) {
  const std::string missing = why_no_workbench();
  if (!missing.empty()) throw InputError("workbench", missing);
  std::vector<std::string> words{"fogcomp workbench"};
  for (const WorkbenchSetup::State& state : setup.states) words.push_back(state.model);
  words.insert(words.end(), setup.runs.begin(), setup.runs.end());
  PageContent content{join(words, " ")};
  content.bench = &setup;
  return framed(content);
}

}  // namespace fogcomp::report
