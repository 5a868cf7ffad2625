#include "xacro/files/nearest_name.hpp"

#include <gtest/gtest.h>

namespace castaway {
namespace {

TEST(NearestName, CountsEdits) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(NearestName, CountsSwappedNeighboursOnce) {
  EXPECT_EQ(edit_distance("ab", "ba"), 1U);
  EXPECT_EQ(edit_distance("range_mxa", "range_max"), 1U);
  EXPECT_EQ(edit_distance("abcd", "badc"), 2U);
  EXPECT_EQ(edit_distance("ca", "abc"), 3U);  // Nothing is edited between swapped neighbours.
}

TEST(NearestName, IsTheFirstOneOfATie) {
  EXPECT_EQ(nearest_name("lidr", {"odometry", "lidar", "seed"}), "lidar");
  EXPECT_EQ(nearest_name("range_mxa", {"range_min", "range_max"}), "range_max");
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
}  // namespace castaway
