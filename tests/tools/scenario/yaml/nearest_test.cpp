#include "tools/scenario/yaml/nearest.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(CloseName, IsAtMostThreeEditsAway) {
  EXPECT_EQ(close_name("--sed", {"--out", "--seed"}), "--seed");
  EXPECT_EQ(close_name("abc", {"xyz"}), "xyz");
  EXPECT_EQ(close_name("abcd", {"wxyz"}), std::nullopt);
  EXPECT_EQ(close_name("x", {}), std::nullopt);
}

TEST(Nearest, SuggestsOrLists) {
  EXPECT_EQ(suggestion("lidr", {"seed", "lidar"}), "did you mean 'lidar'?");
  EXPECT_EQ(suggestion("range_mxa", {"range_min", "range_max"}), "did you mean 'range_max'?");
  EXPECT_EQ(suggestion("colour", {"seed", "lidar"}), "nearest is 'lidar'; known are: seed, lidar");
  EXPECT_EQ(suggestion("x", {}), "no name is known here");
}

}  // namespace
}  // namespace castaway::testbed
