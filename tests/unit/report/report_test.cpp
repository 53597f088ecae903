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

// What a file may be called.
const char* const kHostile = "</script><script>alert(1)</script>&\"x.csv";

TEST(Report, NamesOfFilesCannotBecomeMarkup) {
  Report plain("fogcomp info run.csv", "Found.");
  Report hostile(kHostile, kHostile);
  for (Report* report : {&plain, &hostile}) {
    const std::string name = report == &plain ? "run.csv" : kHostile;
    report->next(name, name);
    report->section(name);
    report->sentence(name);
    report->listing(name);
    report->table({{name}, {{name, name}}});
    report->bars({{{name, {{1, "model", name}}, name}}, 1, name, {{name, "model"}}});
    report->plot({name, name, name, {{name, "model", {1, 2}}}, {0, 1}, {{name, 1}}, name});
  }
  for (const char* tag : {"<script", "</script", "<td", "<figure", "<p"}) {
    EXPECT_EQ(count(hostile.html(), tag), count(plain.html(), tag)) << tag;
  }
  EXPECT_EQ(count(hostile.html(), "alert(1)</"), 0U);
}

TEST(Report, NamesInAnotherEncodingLeaveThePageUtf8) {
  Report report("Z\xFCrich.csv", "60\xB0");
  report.table({{"60\xB0"}, {{"60\xB0"}}});
  report.plot({"60\xB0", "", "", {{"60\xB0", "model", {1, 2}}}, {0, 1}, {}, ""});
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

}  // namespace
}  // namespace fogcomp::report
