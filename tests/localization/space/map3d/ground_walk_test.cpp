#include "localization/space/map3d/ground_walk.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

/// Three cells in a row; the last one has a second surface at 3 m.
ElevationMap three_cells() {
  ElevationMap map;
  map.frame = {3, 1, 1.0, {}};
  map.first = {0, 1, 2, 4};
  for (const float z : {0.0F, 0.02F, 0.04F, 3.0F}) {
    map.surfaces.push_back({z, 0.0F, 0.0F, 9.0F, 0, true});
  }
  map.levels = {0.0F};
  return map;
}

std::size_t walk_from(GroundWalk& walk, const SurfaceAt& start) {
  return walk.from(
      start, [](const GroundSurface& surface) { return surface.drivable; }, [](std::size_t) {});
}

TEST(GroundWalkTest, VisitsWhatIsConnectedOnce) {
  const ElevationMap map = three_cells();
  GroundWalk walk(map, 0.03F);
  EXPECT_EQ(walk_from(walk, {{1, 0}, 1}), 3U);
  EXPECT_EQ(walk_from(walk, {{0, 0}, 0}), 0U);
  EXPECT_EQ(walk_from(walk, {{2, 0}, 3}), 1U);
}

TEST(GroundWalkTest, StepsAndWhatIsNotEnteredEndIt) {
  ElevationMap map = three_cells();
  GroundWalk strict(map, 0.01F);
  EXPECT_EQ(walk_from(strict, {{1, 0}, 1}), 1U);
  map.surfaces[1].drivable = false;
  GroundWalk walk(map, 0.03F);
  EXPECT_EQ(walk_from(walk, {{0, 0}, 0}), 1U);
  EXPECT_EQ(walk_from(walk, {{1, 0}, 1}), 0U);
}

TEST(ForEachSurface, GoesThroughAllCells) {
  std::size_t next = 0;
  for_each_surface(three_cells(), [&](const SurfaceAt& at) {
    EXPECT_EQ(at.index, next++);
    EXPECT_EQ(at.cell.x(), std::min<int>(static_cast<int>(at.index), 2));
  });
  EXPECT_EQ(next, 4U);
}

}  // namespace
}  // namespace castaway::localization
