#include "tools/outputs/records/place_scores.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(PlaceScores, AreThoseOfTheNearestPlace) {
  const PlaceScores scores{{{0.0, 0.0}, {2.0, 0.0}, {0.0, 3.0}}, {0.1, 0.2, 0.3}};
  EXPECT_EQ(scores.at({0.9, 0.1}), 0.1);
  EXPECT_EQ(scores.at({1.1, 0.0}), 0.2);
  EXPECT_EQ(scores.at({1.0, 0.0}), 0.1);
  EXPECT_EQ(scores.at({-5.0, 9.0}), 0.3);
  EXPECT_FALSE(PlaceScores{}.at({0.0, 0.0}));
}

}  // namespace
}  // namespace castaway::testbed
