#include "sim/common/nearest_name.hpp"

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

TEST(NearestName, CountsEdits) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("ab", "ba"), 2U);
}

TEST(NearestName, IsTheFirstOneOfATie) {
  EXPECT_EQ(nearest_name("lidr", {"odometry", "lidar", "seed"}), "lidar");
  EXPECT_EQ(nearest_name("x", {"a", "b"}), "a");
  EXPECT_EQ(nearest_name("x", {}), std::nullopt);
}

TEST(NearestName, IsAMisspellingWithinAThirdOfTheName) {
  EXPECT_TRUE(is_misspelling("ab", "abcd"));
  EXPECT_FALSE(is_misspelling("ab", "abcde"));
  EXPECT_TRUE(is_misspelling("wheel_left", "wheel_rear"));
  EXPECT_FALSE(is_misspelling("wheel_left", "wheel_front"));
}

TEST(NameHint, ListsNamesIfNoneIsNear) {
  EXPECT_EQ(name_hint("lidr", {"seed", "lidar"}), "did you mean 'lidar'?");
  EXPECT_EQ(name_hint("colour", {"seed", "lidar"}), "known: seed, lidar");
  EXPECT_EQ(name_hint("x", {}), "none is defined");
}

}  // namespace
}  // namespace castaway::sim
