#include "report/report.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "report/plots.hpp"
#include "support/text.hpp"

namespace fogcomp::report {
namespace {

using findings::Curve;
using findings::Document;
using findings::Heading;
using findings::Listing;
using findings::Look;
using findings::Plot;
using findings::Sentence;
using findings::Shown;
using findings::Table;
using findings::Text;
using findings::verbatim;

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++found;
  }
  return found;
}

// Every element of a document, with `name` wherever a name from outside may be.
Document full_document(const std::string& name) {
  const Text text = verbatim(name);
  Document document{name, text, {text, name}};
  document.parts = Heading{text} + Sentence{text} + findings::file_heading(name) + Listing{name};
  Table table;
  table.caption = table.notes = text;
  table.columns = {text, text};
  table.rows = {{text, text}};
  table.rows[0].link = name;
  document.parts += table;
  table.quantity = text;
  table.columns = {text, {text, "model"}, {text, "residual"}, text};
  table.rows = {{text, {text, 1}, {text, 2}, text}};
  document.parts += table;
  Plot plot;
  plot.title = plot.x_label = plot.y_label = plot.caption = text;
  plot.curves = {{text, "model", {1, 2}}};
  plot.x = {0, 1};
  plot.names = {text};
  plot.levels = {{text, 1}};
  plot.bands = {{text, 0, 1, "heating"}};
  document.parts += plot;
  return document;
}

// Possible file names.
const char* const kHostile = "</script><script>alert(1)</script>&\"x.csv";

TEST(Page, NamesOfFilesCannotBecomeMarkup) {
  const std::string plain = page(full_document("run.csv"));
  const std::string hostile = page(full_document(kHostile));
  for (const char* tag : {"<script", "</script", "<td", "<figure"}) {
    EXPECT_EQ(count(hostile, tag), count(plain, tag)) << tag;
  }
  EXPECT_EQ(count(hostile, "alert(1)</"), 0U);
}

TEST(Page, NamesOfFilesStayAsTheyAre) {
  const std::string html = page(full_document("run_degC+-2deg_chi^2.csv"));
  const std::string as_long = page(full_document("run_number_12345678x.csv"));
  EXPECT_EQ(count(html, "run_degC+-2deg_chi^2.csv"), count(as_long, "run_number_12345678x.csv"));
  for (const char* sign : {"_°C", "±2", "χ²"}) EXPECT_EQ(count(html, sign), 0U) << sign;
}

TEST(Page, AFileIsHeadedByItsNameWithThePathBeneath) {
  Document document{"subject", "found"};
  document.parts = findings::file_heading("/lab/2024/run.csv", " (holdout)") + Sentence{"first"};
  document.parts += findings::file_heading("plain.csv") + Sentence{"second"};
  const std::string html = page(document);
  EXPECT_EQ(count(html, "<h2>run.csv (holdout)</h2>"), 1U);
  EXPECT_EQ(count(html, "<p class=\"path\">/lab/2024/run.csv</p>"), 1U);
  EXPECT_EQ(count(html, "<h2>plain.csv</h2>"), 1U);
  EXPECT_EQ(count(html, "<p class=\"path\">"), 1U);
}

Table table_of_rms(const char* name, double full) {
  Table table;
  table.quantity = name;
  table.full = full;
  table.columns = {"step", {"rms left", "residual"}, "note"};
  table.rows = {{"before", {"0.25", 0.25}, "as it was"}, {"after", {"0.125", 0.125}, ""}};
  return table;
}

TEST(Page, BarsHaveAnAxisWithANameAndAnEnd) {
  Document document{"subject", "found"};
  document.parts = table_of_rms("rms left, deg/h", 0) + table_of_rms("probability", 1);
  const std::string html = page(document);
  EXPECT_EQ(count(html, "<span>0</span><span class=\"quantity\">rms left, °/h</span><span>0.2500<"),
            1U);
  EXPECT_EQ(count(html, "<span>0</span><span class=\"quantity\">probability</span><span>1<"), 1U);
  EXPECT_EQ(count(html, "width:100.0%"), 1U);
  EXPECT_EQ(count(html, "width:25.0%"), 1U);
  EXPECT_EQ(count(html, "<div class=\"note\">note as it was</div>"), 2U);
}

TEST(Page, AColumnWithASentenceMayBeBrokenAndFiguresMayNot) {
  Document document{"subject", "found"};
  Table table;
  table.columns = {"gyro", "outcome", "reason"};
  table.rows = {{"G1", "fail", "holdout_drift_dph is 0.2, which is above 0.1"}, {"G2", "pass", ""}};
  document.parts += table;
  const std::string html = page(document);
  EXPECT_EQ(count(html, "<td class=\"words\">"), 2U);
  EXPECT_EQ(count(html, "<th class=\"words\">reason"), 1U);
  EXPECT_EQ(count(html, "<td>fail</td>"), 1U);
}

TEST(Page, LeavesOutHeadingsWithNothingBeneath) {
  Document document{"subject", "found"};
  document.parts = Heading{"Empty"} + Table{};
  document.parts += Heading{"Figures"} + show(Shown::in_details, table_of_rms("rms", 0));
  document.parts += Heading{"Words"} + Sentence{"something"};
  const std::string html = page(document);
  EXPECT_EQ(count(html, "<h2>"), 1U);
  EXPECT_EQ(count(html, "<p>Something.</p>"), 1U);
}

TEST(Page, NamesInAnotherEncodingLeaveThePageUtf8) {
  const Text name = verbatim("60\xB0");
  Document document{"Z\xFCrich.csv", name};
  Table table;
  table.columns = {name};
  table.rows = {Table::Row{name}};
  document.parts += table;
  Plot plot;
  plot.title = name;
  plot.x = {0, 1};
  plot.curves = {{name, "model", {1, 2}}};
  document.parts += plot;
  EXPECT_EQ(valid_utf8(page(document)), page(document));
}

TEST(Page, NothingInThePageNamesAPlaceToLoadFrom) {
  Document document{"subject", "found"};
  const std::string html = page(document);
  for (const char* attribute : {" src=", " href=", "@import", "url("}) {
    EXPECT_EQ(count(html, attribute), 0U) << attribute;
  }
  EXPECT_EQ(count(html, "default-src 'none'"), 1U);
}

TEST(Terminal, SaysFirstWhatWasFoundAndWhatToDo) {
  Document document{
      "fogcomp fit run.csv",
      "the model leaves 0.05 deg/h rms",
      {"ask which effect is missing", {"fogcomp", "diagnose", "gyro.model", "run.csv"}}};
  document.parts =
      Sentence{"5 rows"} + Heading{"Error ladder"} + table_of_rms("rms left, deg/h", 0);
  EXPECT_EQ(terminal(document),
            "the model leaves 0.05 deg/h rms\n"
            "  next: fogcomp diagnose gyro.model run.csv\n"
            "  5 rows\n"
            "\n"
            "Error ladder\n"
            "  step    rms left  note\n"
            "  before      0.25  as it was\n"
            "  after      0.125\n");
}

TEST(Terminal, ShowsWhatAPageDrawsOnlyInDetails) {
  Document document{"subject", "found"};
  document.parts = Heading{"Drawn"} + show(Shown::in_details, table_of_rms("rms", 0)) +
                   show(Shown::on_page, Sentence{"on a page"});
  EXPECT_EQ(terminal(document), "found\n");
  EXPECT_EQ(count(terminal(document, true), "Drawn\n  step"), 1U);
}

TEST(Terminal, AlignsByCharactersNotBytes) {
  Document document{"subject", "found"};
  Table table;
  table.columns = {"segment", "mean"};
  table.rows = {{verbatim("Z\xC3\xBCrich"), "1"}, {"soak", "22"}};
  document.parts += table;
  EXPECT_EQ(terminal(document),
            "found\n\n  segment  mean\n  Z\xC3\xBCrich      1\n  soak       22\n");
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

TEST(PlotJson, HasTheSegmentsOfItsAxisAndTheNamesOfItsPoints) {
  Plot plot;
  plot.kind = Plot::Kind::log_x;
  plot.bands = {{"soak 20", 0, 1.5}, {"ramp 20..-40", 1.5, 2, "cooling"}};
  plot.names = {verbatim("SN 0042")};
  const std::string json = plot_json(plot).text();
  EXPECT_NE(json.find(R"({"label":"ramp 20..-40","from":1.5,"to":2,"colour":"cooling"})"),
            std::string::npos)
      << json;
  EXPECT_NE(json.find(R"("names":["SN 0042"])"), std::string::npos) << json;
  EXPECT_NE(json.find(R"("kind":"log_x")"), std::string::npos) << json;
}

}  // namespace
}  // namespace fogcomp::report
