#include "localization/map/hollow.hpp"

#include <gtest/gtest.h>

#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

using Rows = std::vector<std::string>;

std::vector<CellState> hollowed(const Rows& rows, double depth_in_cells) {
  constexpr double kCell = 0.05;
  return hollow(test::string_map(rows, kCell), depth_in_cells * kCell).cells;
}

std::vector<CellState> cells(const Rows& rows) { return test::string_map(rows, 0.05).cells; }

TEST(Hollow, KeepsTheSurfaceOfASolidObstacle) {
  const Rows solid{".......", ".#####.", ".#####.", ".#####.", ".#####.", "......."};
  EXPECT_EQ(hollowed(solid, 1.0),
            cells({".......", ".#####.", ".#   #.", ".#   #.", ".#####.", "......."}));
}

TEST(Hollow, KeepsAtLeastOneCell) {
  EXPECT_EQ(hollowed({".###.", ".###.", ".###."}, 0.0), cells({".# #.", ".# #.", ".# #."}));
}

TEST(Hollow, KeepsThinWalls) {
  const Rows walls{"##..", "##. ", "###.", "...."};
  EXPECT_EQ(hollowed(walls, 2.0), cells(walls));
}

TEST(Hollow, HasNoSurfaceAtTheBorderOfTheMap) {
  EXPECT_EQ(hollowed({"####."}, 1.0), cells({"   #."}));
}

TEST(Hollow, IsEmptyWithoutSurfaces) {
  EXPECT_EQ(hollowed({"##", "##"}, 9.0), cells({"  ", "  "}));
}

}  // namespace
}  // namespace castaway::localization
