#include "findings/findings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace fogcomp::findings {
namespace {

// Ten gyros; the last has twice the noise.
batch::Summary lot_with(const std::vector<batch::Limit>& limits) {
  std::vector<batch::GyroResult> results;
  for (int i = 0; i < 10; ++i) {
    const double noise = i == 9 ? 0.0024 : 0.0012 + 1e-6 * i;
    results.push_back(
        {"G" + std::to_string(i), "", "", {{"noise_dprh", noise}, {"warm_up.A", 0.1 * i}}});
  }
  return batch::summarise(std::move(results), limits, {"noise_dprh"});
}

const Plot& first_plot(const Document& document) {
  for (const Parts::Part& part : document.parts) {
    if (const auto* plot = std::get_if<Plot>(&part.content)) return *plot;
  }
  throw std::logic_error("no plot");
}

TEST(BatchFindings, HaveAHistogramWithTheNameOfEveryGyroAndTheLimit) {
  const Document document =
      batch_findings(lot_with({{"noise_dprh", true, 0.0015}}), "gyros", "out", false);
  const Plot& plot = first_plot(document);
  ASSERT_EQ(plot.curves.size(), 2U);  // the gyros, and those that are named
  std::size_t dots = 0;
  for (std::size_t i = 0; i < plot.x.size(); ++i) {
    const bool is_named = std::isfinite(plot.curves[1].y[i]);
    if (std::isfinite(plot.curves[0].y[i]) || is_named) ++dots;
    EXPECT_EQ(is_named, plot.names[i].plain() == "G9");
  }
  EXPECT_EQ(dots, 10U);
  ASSERT_EQ(plot.bands.size(), 1U);
  EXPECT_EQ(plot.bands[0].from, 0.0015);
  // Beyond the last gyro: of two dots at the edge of a plot only the first is drawn.
  EXPECT_GT(plot.bands[0].to, 0.0024);
  EXPECT_EQ(plot.x.back(), plot.bands[0].to);
  EXPECT_NE(plot.caption.plain().find("G9 0.002400"), std::string::npos) << plot.caption.plain();
}

TEST(BatchFindings, ShowALimitThatNoGyroReaches) {
  const Document document =
      batch_findings(lot_with({{"warm_up.A", true, 1.5}}), "gyros", "out", false);
  const Plot& plot = first_plot(document);
  ASSERT_EQ(plot.bands.size(), 1U);
  EXPECT_EQ(plot.bands[0].from, 1.5);
  EXPECT_EQ(plot.bands[0].to, plot.x.back());
  EXPECT_GT(plot.x.back(), 1.5);
  EXPECT_EQ(plot.x.size(), plot.names.size());
  for (const Curve& curve : plot.curves) EXPECT_EQ(curve.y.size(), plot.x.size());
}

TEST(BatchFindings, NextIsOnlyWhatADiagnosisProposes) {
  batch::Summary summary = lot_with({{"noise_dprh", true, 0.0015}});
  EXPECT_EQ(batch_findings(summary, "gyros", "out", false).next.command, "");
  summary.gyros[9].diagnosis =
      batch::GyroDiagnosis{"", "missing_effect", {"shupe"}, 0.1, 0.9, "shupe is missing", "add it"};
  const Document document = batch_findings(summary, "gyros", "out", false);
  EXPECT_EQ(document.next.command, "add it");
  EXPECT_EQ(summary.gyros[9].why(), "shupe is missing");
}

}  // namespace
}  // namespace fogcomp::findings
