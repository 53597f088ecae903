// A plot for a page on which no script runs.

#include "report/plots.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fogcomp::report {
namespace {

findings::Plot plot_of(std::vector<double> x, std::vector<double> y) {
  findings::Plot plot;
  plot.x_label = "time, h";
  plot.y_label = "rate, deg/h";
  plot.x = std::move(x);
  plot.curves.push_back({"rate", "model", std::move(y)});
  return plot;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

TEST(PlotSvg, NoSpikeOfALongCurveIsLost) {
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i < 100000; ++i) {
    x.push_back(i);
    y.push_back(i == 54321 ? 100 : 0);
  }
  const std::string svg = plot_svg(plot_of(x, y));
  EXPECT_LT(svg.size(), 20000U);
  EXPECT_EQ(occurrences(svg, "V"), 1U) << "a vertical stroke where the spike is";
}

TEST(PlotSvg, AGapBreaksTheCurve) {
  const std::string svg = plot_svg(plot_of({0, 1, 2, 3, 4}, {1, 2, std::nan(""), 2, 1}));
  const std::size_t begin = svg.rfind("<path d=\"");
  const std::string path = svg.substr(begin, svg.find('"', begin + 9) - begin);
  EXPECT_EQ(occurrences(path, "M"), 2U) << path;
  EXPECT_EQ(occurrences(path, "L"), 2U) << path;
}

TEST(PlotSvg, NamesFromFilesAreText) {
  findings::Plot plot = plot_of({0, 1}, {1, 2});
  plot.curves[0].label = findings::verbatim("<script>alert(1)</script>");
  EXPECT_EQ(occurrences(plot_svg(plot), "<script"), 0U);
}

TEST(PlotSvg, LogarithmicAxesLeaveOutWhatTheyCannotShow) {
  findings::Plot plot = plot_of({0, 1, 10, 100}, {1, -1, 10, 100});
  plot.kind = findings::Plot::Kind::log_log;
  const std::string svg = plot_svg(plot);
  EXPECT_EQ(occurrences(svg, "nan"), 0U);
  EXPECT_EQ(occurrences(svg, "inf"), 0U);
}

TEST(PlotSvg, OneValueHasAxes) {
  const std::string svg = plot_svg(plot_of({5}, {3}));
  EXPECT_EQ(occurrences(svg, "nan"), 0U);
  EXPECT_NE(svg.find(">3<"), std::string::npos);
}

}  // namespace
}  // namespace fogcomp::report
