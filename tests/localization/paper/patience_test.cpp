#include "localization/paper/paper_belief.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(Patience, WaitsUntilAnotherHasBeenPreferredLongEnough) {
  Patience patience(0.5);
  EXPECT_EQ(patience.settle(1, 2, from_seconds(1.0)), 1);
  EXPECT_EQ(patience.settle(1, 3, from_seconds(1.4)), 1);  // independent of the id
  EXPECT_EQ(patience.settle(1, 2, from_seconds(1.5)), 2);
}

TEST(Patience, BeginsAnewWhereThePresentOneIsPreferred) {
  Patience patience(0.5);
  EXPECT_EQ(patience.settle(1, 2, from_seconds(1.0)), 1);
  EXPECT_EQ(patience.settle(1, 1, from_seconds(1.4)), 1);
  EXPECT_EQ(patience.settle(1, 2, from_seconds(1.6)), 1);
  EXPECT_EQ(patience.settle(1, 2, from_seconds(2.1)), 2);
  EXPECT_EQ(patience.settle(2, 1, from_seconds(2.2)), 2);
  patience.reset();
  EXPECT_EQ(patience.settle(2, 1, from_seconds(2.8)), 2);
}

TEST(Patience, HasNoneWhereThePresentOneIsGoneOrNobodyWaits) {
  EXPECT_EQ(Patience(0.5).settle({}, 2, Stamp{}), 2);
  EXPECT_EQ(Patience(0.0).settle(1, 2, Stamp{}), 2);
}

}  // namespace
}  // namespace castaway::localization
