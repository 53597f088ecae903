#include "report/report.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/text.hpp"

namespace fogcomp::report {
namespace {

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++found;
  }
  return found;
}

// Everything that a report takes, with `name` wherever a name from outside can stand.
Report full_report(const std::string& name) {
  const Text text = verbatim(name);
  Report report(name, text);
  report.next(text, name);
  report.section(text);
  report.file_section(name);
  report.sentence(text);
  report.listing(name);
  report.table({{text}, {{text, text}}, {name}});
  Bars bars;
  bars.quantity = text;
  bars.rows = {{text, {{1, "model", text}}, text}};
  bars.caption = text;
  bars.keys = {{text, "model"}};
  report.bars(bars);
  Plot plot;
  plot.title = plot.x_label = plot.y_label = plot.caption = text;
  plot.curves = {{text, "model", {1, 2}}};
  plot.x = {0, 1};
  plot.x_names = {text};
  plot.levels = {{text, 1}};
  plot.bands = {{text, 0, 1, "heating"}};
  report.plot(plot);
  return report;
}

// What a file may be called.
const char* const kHostile = "</script><script>alert(1)</script>&\"x.csv";

TEST(Report, NamesOfFilesCannotBecomeMarkup) {
  const std::string plain = full_report("run.csv").html();
  const std::string hostile = full_report(kHostile).html();
  for (const char* tag : {"<script", "</script", "<td", "<figure"}) {
    EXPECT_EQ(count(hostile, tag), count(plain, tag)) << tag;
  }
  EXPECT_EQ(count(hostile, "alert(1)</"), 0U);
}

TEST(Report, NamesOfFilesStayAsTheyAre) {
  const std::string page = full_report("run_degC+-2deg_chi^2.csv").html();
  const std::string as_long = full_report("run_number_12345678x.csv").html();
  EXPECT_EQ(count(page, "run_degC+-2deg_chi^2.csv"), count(as_long, "run_number_12345678x.csv"));
  for (const char* sign : {"_°C", "±2", "χ²"}) EXPECT_EQ(count(page, sign), 0U) << sign;
}

TEST(Report, AFileIsHeadedByItsNameWithThePathBeneath) {
  Report report("subject", "Found.");
  report.file_section("/lab/2024/run.csv", " (holdout)");
  report.file_section("plain.csv");
  const std::string page = report.html();
  EXPECT_EQ(count(page, "<h2>run.csv (holdout)</h2>"), 1U);
  EXPECT_EQ(count(page, "<p class=\"path\">/lab/2024/run.csv</p>"), 1U);
  EXPECT_EQ(count(page, "<h2>plain.csv</h2>"), 1U);
  EXPECT_EQ(count(page, "<p class=\"path\">"), 1U);
}

TEST(Report, BarsHaveAnAxisWithANameAndAnEnd) {
  Report report("subject", "Found.");
  Bars bars;
  bars.quantity = "rms left, deg/h";
  bars.rows = {{"before", {{0.25, "measured", "0.25"}}}};
  report.bars(bars);
  bars.quantity = "probability";
  bars.full = 1;
  report.bars(bars);
  const std::string page = report.html();
  EXPECT_EQ(count(page, "<span>0</span><span class=\"quantity\">rms left, °/h</span><span>0.2500<"),
            1U);
  EXPECT_EQ(count(page, "<span>0</span><span class=\"quantity\">probability</span><span>1<"), 1U);
  EXPECT_EQ(count(page, "width:100.0%"), 1U);
  EXPECT_EQ(count(page, "width:25.0%"), 1U);
}

TEST(Report, AColumnWithASentenceMayBeBrokenAndFiguresMayNot) {
  Report report("subject", "Found.");
  report.table(
      {{"gyro", "outcome", "reason"},
       {{"G1", "fail", "holdout_drift_dph is 0.2, which is above 0.1"}, {"G2", "pass", ""}}});
  const std::string page = report.html();
  EXPECT_EQ(count(page, "<td class=\"words\">"), 2U);
  EXPECT_EQ(count(page, "<th class=\"words\">reason"), 1U);
  EXPECT_EQ(count(page, "<td>fail</td>"), 1U);
}

TEST(Report, NamesInAnotherEncodingLeaveThePageUtf8) {
  const Text name = verbatim("60\xB0");
  Report report("Z\xFCrich.csv", name);
  report.table({{name}, {{name}}});
  Plot plot;
  plot.title = name;
  plot.x = {0, 1};
  plot.curves = {{name, "model", {1, 2}}};
  report.plot(plot);
  EXPECT_EQ(valid_utf8(report.html()), report.html());
}

TEST(Report, NothingInThePageNamesAPlaceToLoadFrom) {
  Report report("subject", "Found.");
  const std::string page = report.html();
  for (const char* attribute : {" src=", " href=", "@import", "url("}) {
    EXPECT_EQ(count(page, attribute), 0U) << attribute;
  }
  EXPECT_EQ(count(page, "default-src 'none'"), 1U);
}

TEST(PlotJson, RoundsFarBelowAPixel) {
  Plot plot;
  plot.x = {0, 1, 2};
  plot.curves = {{"rate", "model", {15.04106861234567, std::nan(""), 15.0511}}};
  EXPECT_NE(plot_json(plot).text().find("[15.0410686,null,15.0511]"), std::string::npos)
      << plot_json(plot).text();
}

TEST(PlotJson, RoundsEachValueOfALogarithmicAxisByItself) {
  Plot plot;
  plot.kind = Plot::Kind::log_log;
  plot.curves = {{"sigma", "model", {1234.5678, 0.000123456789}, {1, 10}}};
  EXPECT_NE(plot_json(plot).text().find("[1234.57,0.000123457]"), std::string::npos)
      << plot_json(plot).text();
}

TEST(PlotJson, HasTheSegmentsAndTheNamesOfAnAxis) {
  Plot plot;
  plot.kind = Plot::Kind::log_y;
  plot.bands = {{"soak 20", 0, 1.5}, {"ramp 20..-40", 1.5, 2, "cooling"}};
  plot.x_names = {verbatim("SN 0042")};
  const std::string json = plot_json(plot).text();
  EXPECT_NE(json.find(R"({"label":"ramp 20..-40","from":1.5,"to":2,"colour":"cooling"})"),
            std::string::npos)
      << json;
  EXPECT_NE(json.find(R"("x_names":["SN 0042"])"), std::string::npos) << json;
  EXPECT_NE(json.find(R"("kind":"log_y")"), std::string::npos) << json;
}

}  // namespace
}  // namespace fogcomp::report
