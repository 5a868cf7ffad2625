#include "tools/scenario/yaml/nearest.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(Nearest, CountsEdits) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("ab", "ba"), 2U);
}

TEST(Nearest, FindsTheNearestAndTheFirstOfEqual) {
  EXPECT_EQ(nearest_name("lidr", {"odometry", "lidar", "seed"}), "lidar");
  EXPECT_EQ(nearest_name("x", {"a", "b"}), "a");
  EXPECT_EQ(nearest_name("x", {}), std::nullopt);
}

TEST(Nearest, SuggestsOrLists) {
  EXPECT_EQ(suggestion("lidr", {"seed", "lidar"}), "did you mean 'lidar'?");
  EXPECT_EQ(suggestion("colour", {"seed", "lidar"}), "nearest is 'lidar'; known are: seed, lidar");
  EXPECT_EQ(suggestion("x", {}), "no name is known here");
}

}  // namespace
}  // namespace castaway::testbed
