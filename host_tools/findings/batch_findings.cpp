#include "findings/findings.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <string_view>

#include "findings/text.hpp"
#include "support/statistics.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

using batch::GyroResult;
using batch::Limit;
using batch::Outcome;
using batch::Summary;

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

// Link to its page or folder. Serial numbers may contain any characters.
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
      text += format("%s%s %g", text.empty() ? "" : ", ", limit.is_max ? "≤" : "≥", limit.value);
  }
  return text.empty() ? Text("-") : verbatim(text);
}

// Proposes the command for the first failed gyro that has one.
Next next_of(const Summary& summary) {
  for (const Summary::Gyro& gyro : summary.gyros) {
    if (!gyro.diagnosis || gyro.diagnosis->next.empty()) continue;
    return {"give " + verbatim(gyro.result.gyro) +
                " the effect that it has and the model has not; it is kept only if it helps out of "
                "sample",
            gyro.diagnosis->next};
  }
  return {};
}

Table rejected_table(const Summary& summary, bool reports) {
  Table table;
  table.columns = {"gyro", "outcome", "reason", "why"};
  for (const Summary::Gyro& gyro : summary.gyros) {
    if (gyro.outcome == Outcome::pass) continue;
    table.rows.push_back({verbatim(gyro.result.gyro), name_of(gyro.outcome), verbatim(gyro.reason),
                          words(gyro.why(), {gyro.result.gyro})});
    table.rows.back().link = link_of(gyro, reports);
  }
  return table;
}

// Gyros that differ from the others, independent of limits.
Parts outliers_section(const Summary& summary) {
  const batch::Lot& lot = summary.lot;
  const Heading heading{"Unlike the others"};
  if (lot.figures.empty()) {
    return heading +
           Sentence{words(format(
               "fewer than %zu gyros have figures: none is compared with the others", kMinLot))};
  }
  const Sentence rule{words(format(
      "of %s each, a gyro is named from %.1f spreads off the median on (spread: 1.4826 times the "
      "median distance); a lot without outliers has one in 1 of 100 cases",
      counted(lot.figures.size(), "figure").c_str(), lot.bound))};
  Table table;
  table.columns = {"gyro", "figure that is off"};
  for (const Summary::Gyro& gyro : summary.gyros) {
    const std::string text = summary.stands_out(gyro.result.gyro);
    if (!text.empty()) table.rows.push_back({verbatim(gyro.result.gyro), words(text)});
  }
  return heading + rule + Sentence{table.rows.empty() ? "no gyro is" : ""} + table;
}

Table notes_table(const Summary& summary) {
  Table table;
  table.columns = {"gyro", "note"};
  for (const Summary::Gyro& gyro : summary.gyros) {
    if (gyro.outcome == Outcome::fail) continue;  // there it is part of the reason
    for (const std::string& note : gyro.result.notes)
      table.rows.push_back({verbatim(gyro.result.gyro), words(note)});
  }
  return table;
}

Table spread_table(const Summary& summary) {
  Table table;
  table.columns = {"figure", "limit", "median", "min", "max", "gyros", "what it is"};
  for (const std::string& figure : summary.figures) {
    const Summary::Spread spread = summary.spread_of(figure);
    table.rows.push_back({verbatim(figure), limits_of(figure, summary.limits),
                          significant(spread.median), significant(spread.min),
                          significant(spread.max), verbatim(std::to_string(spread.gyros)),
                          figure_label(figure)});
  }
  return table;
}

// First the limited values, then the compared ones; without either, the usual ones.
std::vector<std::string> plotted_figures(const Summary& summary) {
  std::vector<std::string> wanted;
  const auto want = [&](const std::string& figure) {
    if (std::find(wanted.begin(), wanted.end(), figure) == wanted.end()) wanted.push_back(figure);
  };
  for (const Limit& limit : summary.limits) want(limit.figure);
  for (const char* figure : {"holdout_drift_dph", "fit_drift_dph"}) want(figure);
  for (const batch::LotFigure& figure : summary.lot.figures) want(figure.name);
  return wanted;
}

struct Place {
  double value = 0;
  std::string gyro;
  bool named = false;  ///< violates a limit of this value, or is an outlier of it
};

std::vector<Place> places_of(const Summary& summary, const std::string& figure) {
  std::vector<Place> places;
  for (const Summary::Gyro& gyro : summary.gyros) {
    const auto value = gyro.result.figure(figure);
    if (!value) continue;
    const bool breaks = std::any_of(
        summary.limits.begin(), summary.limits.end(),
        [&](const Limit& limit) { return limit.figure == figure && !limit.meets(*value); });
    const auto& outliers = summary.lot.outliers;
    const bool is_off =
        std::any_of(outliers.begin(), outliers.end(), [&](const batch::Outlier& outlier) {
          return outlier.figure == figure && outlier.gyro == gyro.result.gyro;
        });
    places.push_back({*value, gyro.result.gyro, breaks || is_off});
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.value < b.value; });
  return places;
}

// Whether one gyro is so far away that the others would coincide on the axis.
bool has_far_outlier(const std::vector<Place>& places) {
  constexpr double kFarOff = 20;
  return places.front().value > 0 &&
         places.back().value > kFarOff * places[places.size() / 2].value;
}

// Width of a bin by Scott's rule, from a spread that is robust against outliers.
double bin_width(std::vector<double> values) {
  const double middle = values[values.size() / 2];
  for (double& value : values) value -= middle;
  const double gyros = static_cast<double>(values.size());
  const double width = 3.49 * sigma_by_median(std::move(values)) / std::cbrt(gyros);
  return width > 0 ? width : 1;
}

// Position of each of the sorted values within its bin, from 1.
std::vector<double> heights_of(const std::vector<double>& values) {
  const double width = bin_width(values);
  std::vector<double> heights;
  double bin_before = -1;
  for (const double value : values) {
    const double bin = std::floor((value - values.front()) / width);
    heights.push_back(bin == bin_before ? heights.back() + 1 : 1);
    bin_before = bin;
  }
  return heights;
}

// A histogram of dots, one per gyro, so that each shows its name.
Plot histogram(const std::vector<Place>& places, const Text& label) {
  Plot plot;
  if (has_far_outlier(places)) plot.kind = Plot::Kind::log_x;
  std::vector<double> drawn_at;
  for (const Place& place : places) {
    plot.x.push_back(place.value);
    plot.names.push_back(verbatim(place.gyro));
    drawn_at.push_back(plot.kind == Plot::Kind::log_x ? std::log(place.value) : place.value);
  }
  const std::vector<double> heights = heights_of(drawn_at);
  Curve gyros{"gyros", "residual", heights};
  Curve named{"beyond a limit, or unlike the others", "mark", heights};
  gyros.look = named.look = Look::points;
  for (std::size_t i = 0; i < places.size(); ++i) {
    (places[i].named ? gyros : named).y[i] = kNothing;
  }
  plot.title = label + ".";
  plot.x_label = label;
  plot.y_label = "gyros";
  plot.is_small = true;
  plot.curves = {std::move(gyros)};
  if (std::any_of(places.begin(), places.end(), [](const Place& one) { return one.named; }))
    plot.curves.push_back(std::move(named));
  return plot;
}

std::string names_of(const std::vector<Place>& places) {
  constexpr std::size_t kMaxNamed = 8;
  std::vector<std::string> names;
  for (const Place& place : places) {
    if (place.named) names.push_back(place.gyro + " " + significant(place.value).plain());
  }
  const std::size_t more = names.size() > kMaxNamed ? names.size() - kMaxNamed : 0;
  names.resize(names.size() - more);
  return join(names, ", ") + (more > 0 ? format(" and %zu more", more) : "");
}

// Whether the gyros remain distinguishable on an axis that includes `limit`.
bool is_near(double limit, const std::vector<Place>& places) {
  constexpr double kSpansBeyond = 2;
  const double span = places.back().value - places.front().value;
  return limit > places.front().value - kSpansBeyond * span &&
         limit < places.back().value + kSpansBeyond * span;
}

// End of the band beyond a limit: a little beyond the limit and the last gyro, whose dot needs a
// margin.
double end_of_band(const Limit& limit, const std::vector<Place>& places, Plot::Kind kind) {
  constexpr double kMore = 0.05;  // margin, as a fraction of the axis
  const double min = std::min(limit.value, places.front().value);
  const double max = std::max(limit.value, places.back().value);
  if (kind == Plot::Kind::log_x && min > 0) {
    const double factor = std::pow(max / min, kMore);
    return limit.is_max ? max * factor : min / factor;
  }
  const double more = kMore * (max - min);
  return limit.is_max ? max + more : min - more;
}

// With an axis that includes `value`, without drawing a dot.
Plot with_on_axis(double value, Plot plot) {
  const auto at = std::lower_bound(plot.x.begin(), plot.x.end(), value) - plot.x.begin();
  plot.x.insert(plot.x.begin() + at, value);
  plot.names.insert(plot.names.begin() + at, Text());
  for (Curve& curve : plot.curves) curve.y.insert(curve.y.begin() + at, kNothing);
  return plot;
}

Plot histogram_of(const Summary& summary, const std::string& figure) {
  const std::vector<Place> places = places_of(summary, figure);
  if (places.empty()) return {};
  const Text label = figure_label(figure).empty() ? verbatim(figure) : figure_label(figure);
  Plot plot = histogram(places, label);
  plot.caption = "Median " + significant(summary.spread_of(figure).median) + ".";
  const std::string named = names_of(places);
  if (!named.empty()) plot.caption += " " + verbatim(named) + ".";
  for (const Limit& limit : summary.limits) {
    if (limit.figure != figure) continue;
    const double end = end_of_band(limit, places, plot.kind);
    if (is_near(limit.value, places)) plot = with_on_axis(end, std::move(plot));
    plot.bands.push_back(
        {"beyond the limit", std::min(limit.value, end), std::max(limit.value, end), "mark"});
    plot.caption += words(format(" Limit: %s %g.", limit.is_max ? "≤" : "≥", limit.value));
  }
  return plot;
}

Table all_table(const Summary& summary, bool reports) {
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
  return table;
}

}  // namespace

Document batch_findings(const Summary& summary, const std::string& input, const std::string& output,
                        bool reports) {
  Document document{"fogcomp batch " + input + " -o " + output, words(headline(summary)),
                    next_of(summary)};
  document.parts = Heading{"Not passed"} + rejected_table(summary, reports);
  document.parts += Heading{"Passed, with a note"} + notes_table(summary);
  if (!summary.figures.empty()) {
    document.parts += outliers_section(summary);
    document.parts +=
        show(Shown::on_page, Heading{"Figures over the gyros"} + spread_table(summary));
    for (const std::string& figure : plotted_figures(summary)) {
      document.parts += histogram_of(summary, figure);
    }
  }
  document.parts +=
      show(Shown::on_page, Heading{"All gyros"} +
                               Sentence{"every figure of every gyro: gyros.csv beside this page"} +
                               all_table(summary, reports));
  return document;
}

}  // namespace fogcomp::findings
