#include "tools/base/formats/level_map.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(LevelAt, IsTheFloorBelow) {
  const LevelMaps levels = {{0.0, {}}, {3.0, {}}, {6.0, {}}};
  EXPECT_EQ(level_at(levels, -1.0), 0U);
  EXPECT_EQ(level_at(levels, 2.4), 0U);  // On a ramp.
  EXPECT_EQ(level_at(levels, 2.6), 1U);  // Its last piece.
  EXPECT_EQ(level_at(levels, 3.0), 1U);
  EXPECT_EQ(level_at(levels, 99.0), 2U);
}

TEST(LevelAt, IsTheFirstOfOne) { EXPECT_EQ(level_at({{5.0, {}}}, 0.0), 0U); }

}  // namespace
}  // namespace castaway::testbed
