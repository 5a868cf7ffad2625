#include "localization/geometry/rate.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(Rate, TakesATurnEveryPeriodATenthEarlyAtMost) {
  Rate rate(10.0);
  EXPECT_TRUE(rate.take_turn(from_seconds(5.0)));  // the first at once
  EXPECT_FALSE(rate.take_turn(from_seconds(5.08)));
  EXPECT_TRUE(rate.take_turn(from_seconds(5.09)));
  EXPECT_FALSE(rate.take_turn(from_seconds(5.17)));  // counted from the last turn
}

TEST(Rate, WaitsForItsFirstPeriodWhereItHasABeginning) {
  Rate rate(0.5, Stamp{});
  EXPECT_FALSE(rate.take_turn(from_seconds(1.7)));
  EXPECT_TRUE(rate.take_turn(from_seconds(1.8)));
}

TEST(Rate, BeginsAnew) {
  Rate at_once(1.0);
  EXPECT_TRUE(at_once.take_turn(from_seconds(100.0)));
  at_once.restart();
  EXPECT_TRUE(at_once.take_turn(from_seconds(1.0)));
  Rate waits(1.0, Stamp{});
  EXPECT_TRUE(waits.take_turn(from_seconds(100.0)));
  waits.restart();
  EXPECT_FALSE(waits.take_turn(from_seconds(0.5)));
  EXPECT_TRUE(waits.take_turn(from_seconds(1.0)));
}

}  // namespace
}  // namespace castaway::localization
