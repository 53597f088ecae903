#include "core/thermal/play.hpp"

#include <gtest/gtest.h>

#include "core/signal/quantities.hpp"

namespace fog {
namespace {

using Operator = Play<BoardNumbers>;

Operator::Value degc(double value) {
  return Operator::Value::from_raw(static_cast<std::int32_t>(value * (1 << 22)));
}

TEST(Play, BeginsInTheMiddleAndKnowsItsHistoryAfterTwiceTheRadius) {
  Operator play(degc(3));
  play.start(degc(20));
  EXPECT_EQ(play.step(degc(20)), degc(0));
  play.step(degc(24));
  EXPECT_FALSE(play.history_known());
  EXPECT_EQ(play.step(degc(26)), degc(3));
  EXPECT_TRUE(play.history_known());
}

TEST(Play, GoesOnAfterAGapFromWhereItWas) {
  Operator play(degc(3));
  play.start(degc(20));
  play.step(degc(30));   // y = 27
  play.start(degc(28));  // still within the radius
  EXPECT_EQ(play.step(degc(28)), degc(1));
  EXPECT_FALSE(play.history_known());
  play.start(degc(10));  // the gap has taken it along
  EXPECT_EQ(play.step(degc(10)), degc(-3));
}

}  // namespace
}  // namespace fog
