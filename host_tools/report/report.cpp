#include "report/report.hpp"

#include <algorithm>
#include <stdexcept>

#include "report/embedded_page.hpp"
#include "report/figures.hpp"
#include "support/text.hpp"

namespace fogcomp::report {
namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

std::string escaped(std::string text) {
  text = valid_utf8(text);
  replace_all(text, "&", "&amp;");
  replace_all(text, "<", "&lt;");
  replace_all(text, ">", "&gt;");
  replace_all(text, "\"", "&quot;");
  return text;
}

std::string escaped(const Text& text) {
  return escaped(text.utf8());
}

std::string element(const char* tag, const std::string& content) {
  return format("<%s>%s</%s>\n", tag, content.c_str(), tag);
}

// As data for a script: nothing in it may end the element.
std::string script_data(const Json& json) {
  std::string text = json.text();
  replace_all(text, "<", "\\u003c");
  return text;
}

const std::string& file(const std::vector<EmbeddedFile>& files, const std::string& name) {
  for (const EmbeddedFile& one : files) {
    if (one.name == name) return one.text;
  }
  throw std::logic_error("no file '" + name + "' was compiled in");
}

// "left:12.3%", of the whole width
std::string share_style(const char* property, double value, double most) {
  const double share = most > 0 ? std::clamp(value / most, 0.0, 1.0) : 0;
  return format("%s:%.1f%%", property, 100 * share);
}

// Figures stay on one line, sentences may be broken: by column, so that all of it looks the same.
bool is_column_of_words(const Table& table, std::size_t column) {
  constexpr std::size_t kLongestFigure = 24;
  return column > 0 && std::any_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
           return column < row.size() && row[column].utf8().size() > kLongestFigure;
         });
}

// A row of a table. The first cell is its name, as is the whole head.
std::string row_element(const Table& table, const std::vector<Text>& row, const std::string& link) {
  std::string html = "<tr>";
  for (std::size_t column = 0; column < row.size(); ++column) {
    const char* const tag = column == 0 || &row == &table.head ? "th" : "td";
    std::string content = escaped(row[column]);
    if (column == 0 && !link.empty()) {
      content = "<a href=\"" + escaped(link) + "\">" + content + "</a>";
    }
    html +=
        format("<%s%s>%s</%s>", tag, is_column_of_words(table, column) ? " class=\"words\"" : "",
               content.c_str(), tag);
  }
  return html + "</tr>";
}

double full_length(const Bars& bars) {
  double full = std::max(bars.full, bars.floor);
  for (const Bars::Row& row : bars.rows) {
    for (const Bars::Bar& bar : row.bars) full = std::max(full, bar.value);
  }
  return full;
}

std::string bar_element(const Bars::Bar& bar, double full, double floor) {
  std::string html = "<div class=\"bar\"><span class=\"track\"><span class=\"fill\" style=\"" +
                     share_style("width", bar.value, full) + ";background:var(--" + bar.colour +
                     ")\"></span>";
  if (floor > 0) {
    html += "<span class=\"mark\" style=\"" + share_style("left", floor, full) + "\"></span>";
  }
  return html + "</span><span class=\"value\">" + escaped(bar.text) + "</span></div>";
}

// Below the bars: the scale and what it is of.
std::string axis_element(const Text& quantity, double full) {
  return "<div class=\"row axis\"><div></div><div class=\"bar\"><span "
         "class=\"scale\"><span>0</span>"
         "<span class=\"quantity\">" +
         escaped(quantity) + "</span><span>" + escaped(significant(full)) +
         "</span></span><span class=\"value\"></span></div></div>\n";
}

// How to read and handle the plots of any report, and what is drawn of long runs.
constexpr const char* kHowToRead =
    "Drag across a plot to zoom in time or in both directions, double-click to see all again; "
    "click on a name in a legend to hide or show its curve. Shaded: red while the chamber heats, "
    "blue while it cools. Heating and cooling in plots over another quantity: the direction in "
    "which the temperature last moved; soaks count with the ramp before them. Of a curve of more "
    "than 4000 rows, the minimum and maximum of each of 2000 intervals are drawn; clouds of more "
    "than 2000 points are means of neighbouring rows.";

}  // namespace

Report::Report(std::string subject, Text found)
    : subject_(std::move(subject)), found_(std::move(found)) {}

void Report::next(const Text& sentence, const std::string& command) {
  body_ += "<p class=\"next\"><strong>Next:</strong> " + escaped(sentence) + "</p>\n";
  if (!command.empty()) body_ += "<pre class=\"command\">" + escaped(command) + "</pre>\n";
}

void Report::begin_section(const std::string& heading) {
  body_ += in_section_ ? "</section>\n<section>\n" : "<section>\n";
  in_section_ = true;
  body_ += element("h2", heading);
}

void Report::section(const Text& heading) {
  begin_section(escaped(heading));
}

void Report::file_section(const std::string& path, const Text& remark) {
  const std::string name = short_names({path})[0];
  begin_section(escaped(verbatim(name) + remark));
  if (name != path) body_ += "<p class=\"path\">" + escaped(path) + "</p>\n";
}

void Report::sentence(const Text& text) {
  body_ += element("p", escaped(text));
}

void Report::listing(const std::string& text) {
  body_ += element("pre", escaped(text));
}

void Report::table(const Table& table) {
  // A narrow screen scrolls it sideways; the keyboard too.
  body_ += "<div class=\"scroll\" tabindex=\"0\"><table>\n<thead>" +
           row_element(table, table.head, "") + "</thead>\n<tbody>\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    body_ += row_element(table, table.rows[i], table.links.empty() ? "" : table.links[i]) + "\n";
  }
  body_ += "</tbody></table></div>\n";
}

void Report::bars(const Bars& bars) {
  const double full = full_length(bars);
  const bool notes = std::any_of(bars.rows.begin(), bars.rows.end(),
                                 [](const Bars::Row& row) { return !row.note.empty(); });
  body_ += format("<figure class=\"bars%s\">\n", notes ? " notes" : "");
  std::string caption = escaped(bars.caption);
  for (const Bars::Key& key : bars.keys) {
    caption += " <span class=\"key\" style=\"background:var(--" + key.colour + ")\"></span> " +
               escaped(key.label);
  }
  if (!caption.empty()) body_ += element("figcaption", caption);
  for (const Bars::Row& row : bars.rows) {
    body_ += "<div class=\"row\"><div class=\"name\">" + escaped(row.name) + "</div><div>";
    for (const Bars::Bar& bar : row.bars) body_ += bar_element(bar, full, bars.floor);
    body_ += "</div>";
    if (notes) body_ += "<div class=\"note\">" + escaped(row.note) + "</div>";
    body_ += "</div>\n";
  }
  body_ += axis_element(bars.quantity, full) + "</figure>\n";
}

void Report::plot(const Plot& plot) {
  if (plot.curves.empty()) return;
  if (plot_library_files().empty()) {
    ++plot_count_;
    return;
  }
  body_ += "<figure class=\"plot\">\n" +
           element("figcaption",
                   "<strong>" + escaped(plot.title) + "</strong> " + escaped(plot.caption));
  body_ += format("<div class=\"canvas\" data-plot=\"%zu\" role=\"img\" aria-label=\"%s\"></div>\n",
                  plot_count_++, escaped(plot.title + " " + plot.caption).c_str());
  body_ += "</figure>\n";
  plots_.push(plot_json(plot));
}

std::string Report::html() const {
  const std::vector<EmbeddedFile>& library = plot_library_files();
  const bool drawn = !library.empty();
  std::string body = element("h1", escaped(found_));
  if (!drawn && plot_count_ > 0) {
    body += element("p", "No plots here: this fogcomp was built without npm.");
  }
  body += body_ + (in_section_ ? "</section>\n" : "");
  if (drawn && plot_count_ > 0) body += element("footer", escaped(Text(kHowToRead)));
  const std::vector<std::pair<std::string, std::string>> parts{
      {"subject", escaped(subject_)},
      {"style", (drawn ? file(library, "style") : "") + file(page_files(), "style")},
      {"licence", drawn ? file(library, "licence") : ""},
      {"library", drawn ? file(library, "script") : ""},
      {"data", script_data(plots_)},
      {"script", drawn ? file(page_files(), "plots") : ""},
      {"body", body},
  };
  const std::string& frame = file(page_files(), "frame");
  std::string page;
  std::size_t at = 0;
  while (true) {
    const std::size_t open = frame.find("{{", at);
    page.append(frame, at, open - at);
    if (open == std::string::npos) return page;
    const std::size_t close = frame.find("}}", open);
    const std::string name = frame.substr(open + 2, close - open - 2);
    const auto part = std::find_if(parts.begin(), parts.end(),
                                   [&](const auto& one) { return one.first == name; });
    if (part == parts.end()) throw std::logic_error("no part '" + name + "' for the page");
    page += part->second;
    at = close + 2;
  }
}

}  // namespace fogcomp::report
