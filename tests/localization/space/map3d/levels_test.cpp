#include "localization/space/map3d/levels.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

/// A row of cells of 1 m, one surface each, at these heights.
ElevationMap row(const std::vector<float>& heights) {
  ElevationMap map;
  map.frame = {static_cast<int>(heights.size()), 1, 1.0, {}};
  map.first.push_back(0);
  for (const float z : heights) {
    map.surfaces.push_back({z, 0.0F, 0.0F, 9.0F, 0, true});
    map.first.push_back(static_cast<std::uint32_t>(map.surfaces.size()));
  }
  return map;
}

constexpr LevelConfig kSmall{0.02, 3.0, 1.0};

TEST(Levels, AreConnectedLevelSurfacesOfSomeArea) {
  ElevationMap map = row({0, 0, 0, 3, 3, 3, 3, 6, 6});
  label_levels(map, kSmall);
  EXPECT_EQ(map.levels, (std::vector<float>{0.0F, 3.0F}));
  EXPECT_EQ(map.surfaces[2].level, 0);
  EXPECT_EQ(map.surfaces[3].level, 1);
  EXPECT_EQ(map.surfaces[8].level, 1);  // Too small to be a level of its own.
}

TEST(Levels, FloorsOfNearlyOneHeightAreOne) {
  ElevationMap map = row({0, 0, 0, 0.5F, 0.5F, 0.5F, 4, 4, 4});
  label_levels(map, kSmall);
  EXPECT_EQ(map.levels, (std::vector<float>{0.25F, 4.0F}));
}

TEST(Levels, SlopesAndWhatIsNotDrivableMakeNone) {
  ElevationMap map = row({1, 1, 1, 2, 2, 2});
  for (std::size_t i = 0; i < 3; ++i) map.surfaces[i].slope_x = 0.1F;
  for (std::size_t i = 3; i < 6; ++i) map.surfaces[i].drivable = false;
  label_levels(map, kSmall);
  EXPECT_EQ(map.levels, std::vector<float>{1.0F});
  for (const GroundSurface& surface : map.surfaces) EXPECT_EQ(surface.level, 0);
}

}  // namespace
}  // namespace castaway::localization
