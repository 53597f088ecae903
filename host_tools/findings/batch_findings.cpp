#include "findings/batch_findings.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <string_view>

#include "findings/figures.hpp"
#include "findings/labels.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

using batch::GyroResult;
using batch::Limit;
using batch::Outcome;
using batch::Summary;

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

// Its page, or its folder. Serial numbers may have any character in them.
std::string link_of(const Summary::Gyro& gyro, bool reports) {
  std::string link = "./";
  for (const char character : gyro.result.gyro) {
    const bool plain = std::isalnum(static_cast<unsigned char>(character)) != 0 ||
                       std::string_view("-_.").find(character) != std::string_view::npos;
    link +=
        plain ? std::string(1, character) : format("%%%02X", static_cast<unsigned char>(character));
  }
  const bool has_page = reports && gyro.outcome != Outcome::error;
  return link + (has_page ? "/report.html" : "/");
}

Text limits_of(const std::string& figure, const std::vector<Limit>& limits) {
  std::string text;
  for (const Limit& limit : limits) {
    if (limit.figure == figure)
      text += format("%s%s %g", text.empty() ? "" : ", ", limit.is_most ? "≤" : "≥", limit.value);
  }
  return text.empty() ? Text("-") : verbatim(text);
}

// What an engineer would do with the first that fails.
void add_next(Document& document, const Summary& summary, const std::string& input,
              const std::string& output) {
  const auto failing =
      std::find_if(summary.gyros.begin(), summary.gyros.end(),
                   [](const Summary::Gyro& gyro) { return gyro.outcome == Outcome::fail; });
  if (failing == summary.gyros.end()) return;
  const std::string& name = failing->result.gyro;
  document.next_line("ask which effect " + verbatim(name) + " has that the others have not",
                     "fogcomp diagnose " + output + "/" + name + "/" + name + ".model " + input +
                         "/" + name + "/*");
}

void add_rejected(Document& document, const Summary& summary, bool reports) {
  Table table;
  table.columns = {"gyro", "outcome", "reason"};
  for (const Summary::Gyro& gyro : summary.gyros) {
    if (gyro.outcome == Outcome::pass) continue;
    table.rows.push_back(
        {verbatim(gyro.result.gyro), name_of(gyro.outcome), verbatim(gyro.reason)});
    table.rows.back().link = link_of(gyro, reports);
  }
  document.heading("Not passed");
  document.table(std::move(table));
}

std::vector<double> values_of(const Summary& summary, const std::string& figure) {
  std::vector<double> values;
  for (const Summary::Gyro& gyro : summary.gyros) {
    if (const auto value = gyro.result.figure(figure)) values.push_back(*value);
  }
  std::sort(values.begin(), values.end());
  return values;
}

double median_of(const std::vector<double>& sorted) {
  return sorted[sorted.size() / 2];
}

void add_spread(Document& document, const Summary& summary) {
  Table table;
  table.columns = {"figure", "limit", "median", "min", "max", "gyros", "what it is"};
  for (const std::string& figure : summary.figures) {
    const std::vector<double> values = values_of(summary, figure);
    table.rows.push_back({verbatim(figure), limits_of(figure, summary.limits),
                          significant(median_of(values)), significant(values.front()),
                          significant(values.back()), verbatim(std::to_string(values.size())),
                          figure_label(figure)});
  }
  document.heading("Figures over the gyros");
  document.table(std::move(table), Shown::on_page);
}

// What is worth a plot: what is limited, else what a line looks at first.
std::vector<std::string> plotted_figures(const Summary& summary) {
  std::vector<std::string> wanted{"holdout_drift_dph", "fit_drift_dph"};
  if (!summary.limits.empty()) wanted.clear();
  for (const Limit& limit : summary.limits) {
    if (std::find(wanted.begin(), wanted.end(), limit.figure) == wanted.end()) {
      wanted.push_back(limit.figure);
    }
  }
  return wanted;
}

// Whether one gyro is so far off that the others would lie on one line.
bool has_outlier(const std::vector<double>& sorted) {
  constexpr double kFarOff = 20;
  return sorted.front() > 0 && sorted.back() > kFarOff * median_of(sorted);
}

void add_plots(Document& document, const Summary& summary) {
  for (const std::string& figure : plotted_figures(summary)) {
    const std::vector<double> sorted = values_of(summary, figure);
    if (sorted.empty()) continue;
    const Text label = figure_label(figure).empty() ? verbatim(figure) : figure_label(figure);
    Curve curve{label, "residual", {}};
    curve.look = Look::points;
    Plot plot;
    std::string worst;
    for (std::size_t i = 0; i < summary.gyros.size(); ++i) {
      const GyroResult& gyro = summary.gyros[i].result;
      plot.x.push_back(static_cast<double>(i + 1));
      plot.x_names.push_back(verbatim(gyro.gyro));
      curve.y.push_back(gyro.figure(figure).value_or(kNothing));
      if (curve.y.back() == sorted.back()) worst = gyro.gyro;
    }
    plot.title = label + ".";
    plot.x_label = "gyro";
    plot.y_label = label;
    plot.caption = "Median " + significant(median_of(sorted)) + "; largest: " + verbatim(worst) +
                   ", " + significant(sorted.back()) + ".";
    plot.curves.push_back(std::move(curve));
    for (const Limit& limit : summary.limits) {
      if (limit.figure == figure) plot.levels.push_back({"limit", limit.value});
    }
    const bool limits_are_positive = std::all_of(plot.levels.begin(), plot.levels.end(),
                                                 [](const Level& level) { return level.y > 0; });
    if (has_outlier(sorted) && limits_are_positive) plot.kind = Plot::Kind::log_y;
    plot.group = "gyros";
    document.plot(plot);
  }
}

void add_all(Document& document, const Summary& summary, bool reports) {
  Table table;
  table.columns = {"gyro", "outcome"};
  std::vector<std::string> shown;
  for (const char* figure : {"holdout_drift_dph", "fit_drift_dph", "holdout_rms_dph", "fit_rms_dph",
                             "fit_raw_std_dph", "noise_dprh"}) {
    const auto& all = summary.figures;
    if (std::find(all.begin(), all.end(), figure) == all.end()) continue;
    shown.emplace_back(figure);
    table.columns.emplace_back(figure_label(figure));
  }
  for (const Summary::Gyro& gyro : summary.gyros) {
    Table::Row row{verbatim(gyro.result.gyro), name_of(gyro.outcome)};
    for (const std::string& figure : shown) {
      const auto value = gyro.result.figure(figure);
      row.cells.emplace_back(value ? significant(*value) : Text("-"));
    }
    row.link = link_of(gyro, reports);
    table.rows.push_back(std::move(row));
  }
  document.heading("All gyros");
  document.sentence("every figure of every gyro: gyros.csv beside this page", Shown::on_page);
  document.table(std::move(table), Shown::on_page);
}

}  // namespace

Document batch_findings(const Summary& summary, const std::string& input, const std::string& output,
                        bool reports) {
  Document document("fogcomp batch " + input + " -o " + output, words(headline(summary)));
  add_next(document, summary, input, output);
  add_rejected(document, summary, reports);
  if (!summary.figures.empty()) {
    add_spread(document, summary);
    add_plots(document, summary);
  }
  add_all(document, summary, reports);
  return document;
}

}  // namespace fogcomp::findings
