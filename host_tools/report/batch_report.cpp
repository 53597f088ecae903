#include "report/batch_report.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "report/figures.hpp"
#include "support/text.hpp"

namespace fogcomp::report {
namespace {

using batch::Limit;
using batch::Outcome;
using batch::Summary;

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

std::string limits_of(const std::string& figure, const std::vector<Limit>& limits) {
  std::string text;
  for (const Limit& limit : limits) {
    if (limit.figure == figure)
      text += format("%s%s %g", text.empty() ? "" : ", ", limit.is_most ? "≤" : "≥", limit.value);
  }
  return text.empty() ? "-" : text;
}

// What an engineer would do with the first that fails.
void add_next(Report& report, const Summary& summary, const std::string& input,
              const std::string& output) {
  const auto failing =
      std::find_if(summary.gyros.begin(), summary.gyros.end(),
                   [](const Summary::Gyro& gyro) { return gyro.outcome == Outcome::fail; });
  if (failing == summary.gyros.end()) return;
  const std::string& name = failing->result.gyro;
  report.next("ask which effect " + name + " has that the others have not.",
              "fogcomp diagnose " + output + "/" + name + "/" + name + ".model " + input + "/" +
                  name + "/*");
}

void add_rejected(Report& report, const Summary& summary, bool reports) {
  Table table{{"gyro", "outcome", "reason"}, {}, {}};
  for (const Summary::Gyro& gyro : summary.gyros) {
    if (gyro.outcome == Outcome::pass) continue;
    table.rows.push_back({gyro.result.gyro, name_of(gyro.outcome), gyro.reason});
    table.links.push_back(link_of(gyro, reports));
  }
  if (table.rows.empty()) return;
  report.section("Not passed");
  report.table(table);
}

std::vector<double> values_of(const Summary& summary, const std::string& figure) {
  std::vector<double> values;
  for (const Summary::Gyro& gyro : summary.gyros) {
    if (const auto value = gyro.result.figure(figure)) values.push_back(*value);
  }
  std::sort(values.begin(), values.end());
  return values;
}

void add_spread(Report& report, const Summary& summary) {
  Table table{{"figure", "gyros", "least", "median", "most", "limit"}, {}, {}};
  for (const std::string& figure : summary.figures) {
    const std::vector<double> values = values_of(summary, figure);
    table.rows.push_back({figure, format("%zu", values.size()), format("%.4g", values.front()),
                          format("%.4g", values[values.size() / 2]), format("%.4g", values.back()),
                          limits_of(figure, summary.limits)});
  }
  report.section("Figures over the gyros");
  report.table(table);
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

void add_plots(Report& report, const Summary& summary) {
  for (const std::string& figure : plotted_figures(summary)) {
    Curve curve{"gyro", "residual", {}};
    curve.look = Look::points;
    Plot plot;
    for (std::size_t i = 0; i < summary.gyros.size(); ++i) {
      const auto value = summary.gyros[i].result.figure(figure);
      if (!value) continue;
      plot.x.push_back(static_cast<double>(i + 1));
      curve.y.push_back(*value);
    }
    if (curve.y.empty()) continue;
    plot.title = figure + ".";
    plot.x_label = "gyro, in the order of the table";
    plot.y_label = figure;
    plot.curves.push_back(std::move(curve));
    for (const Limit& limit : summary.limits) {
      if (limit.figure == figure) plot.levels.push_back({"limit", limit.value});
    }
    plot.group = "gyros";
    report.plot(plot);
  }
}

void add_all(Report& report, const Summary& summary, bool reports) {
  Table table{{"gyro", "outcome"}, {}, {}};
  std::vector<std::string> shown;
  for (const char* figure : {"fit_raw_std_dph", "fit_rms_dph", "fit_drift_dph", "holdout_rms_dph",
                             "holdout_drift_dph", "noise_dprh"}) {
    const auto& all = summary.figures;
    if (std::find(all.begin(), all.end(), figure) != all.end()) shown.emplace_back(figure);
  }
  table.head.insert(table.head.end(), shown.begin(), shown.end());
  for (const Summary::Gyro& gyro : summary.gyros) {
    std::vector<std::string> row{gyro.result.gyro, name_of(gyro.outcome)};
    for (const std::string& figure : shown) {
      const auto value = gyro.result.figure(figure);
      row.push_back(value ? format("%.4g", *value) : "-");
    }
    table.rows.push_back(std::move(row));
    table.links.push_back(link_of(gyro, reports));
  }
  report.section("All gyros");
  report.sentence("Every figure of every gyro: gyros.csv beside this page.");
  report.table(table);
}

}  // namespace

Report batch_report(const Summary& summary, const std::string& input, const std::string& output,
                    bool reports) {
  Report report("fogcomp batch " + input + " -o " + output, headline(summary) + ".");
  add_next(report, summary, input, output);
  add_rejected(report, summary, reports);
  if (!summary.figures.empty()) {
    add_spread(report, summary);
    add_plots(report, summary);
  }
  add_all(report, summary, reports);
  return report;
}

}  // namespace fogcomp::report
