#include "report/report.hpp"

#include <algorithm>
#include <stdexcept>

#include "report/embedded_page.hpp"
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

std::string typeset(std::string text) {
  replace_all(text, "sqrt(h)", "√h");
  replace_all(text, "deg/", "°/");
  replace_all(text, "degC", "°C");
  replace_all(text, "+-", "±");
  replace_all(text, "chi^2", "χ²");
  replace_all(text, " -> ", " → ");
  return text;
}

std::string words(const std::string& text) {
  return escaped(typeset(text));
}

std::string element(const char* tag, const std::string& content) {
  return format("<%s>%s</%s>\n", tag, content.c_str(), tag);
}

// As data for a script: nothing in it may end the element.
std::string script_data(const Json& json) {
  std::string text = typeset(json.text());
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

}  // namespace

Report::Report(std::string subject, std::string found)
    : subject_(std::move(subject)), found_(std::move(found)) {}

void Report::next(const std::string& sentence, const std::string& command) {
  body_ += "<p class=\"next\"><strong>Next:</strong> " + words(sentence) + "</p>\n";
  if (!command.empty()) body_ += "<pre class=\"command\">" + escaped(command) + "</pre>\n";
}

void Report::section(const std::string& heading) {
  body_ += in_section_ ? "</section>\n<section>\n" : "<section>\n";
  in_section_ = true;
  body_ += element("h2", words(heading));
}

void Report::sentence(const std::string& text) {
  body_ += element("p", words(text));
}

void Report::listing(const std::string& text) {
  body_ += element("pre", words(text));
}

void Report::table(const Table& table) {
  body_ += "<div class=\"scroll\"><table>\n<thead><tr>";
  for (const std::string& cell : table.head) body_ += "<th>" + words(cell) + "</th>";
  body_ += "</tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::vector<std::string>& row = table.rows[i];
    body_ += "<tr>";
    for (const std::string& cell : row) {
      const bool is_name = &cell == row.data();
      std::string content = words(cell);
      if (is_name && !table.links.empty()) {
        content = "<a href=\"" + escaped(table.links[i]) + "\">" + content + "</a>";
      }
      const char* tag = is_name ? "th" : "td";
      body_ += format("<%s>%s</%s>", tag, content.c_str(), tag);
    }
    body_ += "</tr>\n";
  }
  body_ += "</tbody></table></div>\n";
}

void Report::bars(const Bars& bars) {
  double most = bars.floor;
  for (const Bars::Row& row : bars.rows) {
    for (const Bars::Bar& bar : row.bars) most = std::max(most, bar.value);
  }
  const bool notes = std::any_of(bars.rows.begin(), bars.rows.end(),
                                 [](const Bars::Row& row) { return !row.note.empty(); });
  body_ += format("<figure class=\"bars%s\">\n", notes ? " notes" : "");
  std::string caption = words(bars.caption);
  for (const Bars::Key& key : bars.keys) {
    caption += " <span class=\"key\" style=\"background:var(--" + key.colour + ")\"></span> " +
               words(key.label);
  }
  if (!caption.empty()) body_ += element("figcaption", caption);
  for (const Bars::Row& row : bars.rows) {
    body_ += "<div class=\"row\"><div class=\"name\">" + words(row.name) + "</div><div>";
    for (const Bars::Bar& bar : row.bars) {
      body_ += "<div class=\"bar\"><span class=\"track\"><span class=\"fill\" style=\"" +
               share_style("width", bar.value, most) + ";background:var(--" + bar.colour +
               ")\"></span>";
      if (bars.floor > 0) {
        body_ +=
            "<span class=\"mark\" style=\"" + share_style("left", bars.floor, most) + "\"></span>";
      }
      body_ += "</span><span class=\"value\">" + words(bar.text) + "</span></div>";
    }
    body_ += "</div>";
    if (notes) body_ += "<div class=\"note\">" + words(row.note) + "</div>";
    body_ += "</div>\n";
  }
  body_ += "</figure>\n";
}

void Report::plot(const Plot& plot) {
  if (plot.curves.empty()) return;
  if (plot_library_files().empty()) {
    ++plot_count_;
    return;
  }
  body_ +=
      "<figure class=\"plot\">\n" +
      element("figcaption", "<strong>" + words(plot.title) + "</strong> " + words(plot.caption));
  body_ += format("<div class=\"canvas\" data-plot=\"%zu\" role=\"img\" aria-label=\"%s\"></div>\n",
                  plot_count_++, words(plot.title + ". " + plot.caption).c_str());
  body_ += "</figure>\n";
  plots_.push(plot_json(plot));
}

std::string Report::html() const {
  const std::vector<EmbeddedFile>& library = plot_library_files();
  const bool drawn = !library.empty();
  std::string body = element("h1", words(found_));
  if (!drawn && plot_count_ > 0) {
    body += element("p", "No plots here: this fogcomp was built without npm.");
  }
  body += body_ + (in_section_ ? "</section>\n" : "");
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
