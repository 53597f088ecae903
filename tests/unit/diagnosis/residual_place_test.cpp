#include "diagnosis/residual_place.hpp"

#include <gtest/gtest.h>

namespace fogcomp::diagnosis {
namespace {

using recording::Segment;
using recording::SegmentKind;

// Rows as directions: temperature describes the first two rows, time the third, nothing the fourth.
// Two rows to a segment.
ResidualPlace place_of_rows(const Eigen::Vector4d& residual) {
  const Eigen::MatrixXf axes = Eigen::MatrixXf::Identity(4, 4);
  const VisibleStructure structure{
      {"temperature_degc", "time_s"}, {axes.leftCols(2), axes.col(2)}, axes.leftCols(3), {}};
  const std::vector<Segment> segments{{"soak 20", SegmentKind::soak, 0, 20, {0, 2}},
                                      {"ramp 20..60", SegmentKind::ramp_up, 20, 40, {2, 4}}};
  return place_of(structure, residual, segments);
}

TEST(ResidualPlace, SaysOnWhatAndWhereByWhatIsSmooth) {
  const ResidualPlace place = place_of_rows({3, 4, 10, 1000});
  EXPECT_EQ(place.variable, "time_s");
  EXPECT_EQ(place.variables[1].share, 1);
  // ln of the evidence: (25 - 2) / 2 - ln(25 / 2) beside (100 - 1) / 2 - ln(100) / 2.
  EXPECT_NEAR(place.variables[0].share, 8.974271 / 47.197415, 1e-6);
  // Squares of 25 and 100; the last row is not smooth.
  EXPECT_EQ(place.segments[0].name, "soak 20");
  EXPECT_NEAR(place.segments[0].share, 0.2, 1e-12);
  EXPECT_NEAR(place.segments[1].share, 0.8, 1e-12);
}

// Of two columns one may explain as much as the other two by chance: evidence counts columns.
TEST(ResidualPlace, IsOnNothingWhereNoVariableExplainsMoreThanItsColumns) {
  const ResidualPlace place = place_of_rows({1, 1, 1, 50});
  EXPECT_EQ(place.variable, "");
  for (const NamedShare& variable : place.variables) EXPECT_EQ(variable.share, 0);
  EXPECT_NEAR(place.segments[0].share, 2.0 / 3, 1e-12);
}

TEST(ResidualPlace, OfNothingIsNowhere) {
  const ResidualPlace place = place_of_rows({0, 0, 0, 0});
  EXPECT_EQ(place.variable, "");
  for (const NamedShare& segment : place.segments) EXPECT_EQ(segment.share, 0);
}

}  // namespace
}  // namespace fogcomp::diagnosis
