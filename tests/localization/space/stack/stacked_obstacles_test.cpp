#include "localization/space/stack/stacked_obstacles.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/localization/space/map3d/building.hpp"

namespace castaway::localization {
namespace {

/// Distance from a point to a box. [m]
double distance_to(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& p) {
  return box.exteriorDistance(p);
}

/// True if drivable ground in this plane or below it is above the point.
bool is_under(const ElevationMap& ground, const StackFrame& stack, const Eigen::Vector3d& p,
              int plane) {
  const SE2 T_grid_map = ground.frame.T_map_grid.inverse();
  const Eigen::Vector2d p_grid = T_grid_map * Eigen::Vector2d(p.head<2>());
  for (const GroundSurface& surface : ground.at(ground.frame.cell_of(p_grid))) {
    const auto z = static_cast<double>(surface.z);
    if (surface.drivable && z > p.z() && stack.plane_of(z) <= plane) return true;
  }
  return false;
}

TEST(StackedObstacles, BytesAreThoseOfTheNearestObstacle) {
  constexpr double kSigma = 0.15;
  Rng rng = substream(1, "stacked_obstacles");
  const test::Building building(rng, 4);
  const ElevationMap& ground = building.volume().atlas().ground();
  const VoxelMap& voxels = building.volume().voxels();
  const StackFrame stack(ground, StackConfig{});
  const auto bytes = stack_obstacles(voxels, ground, stack, kSigma);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3i at(static_cast<int>(test::uniform(0.0, stack.plane.width, rng)),
                             static_cast<int>(test::uniform(0.0, stack.plane.height, rng)),
                             static_cast<int>(test::uniform(0.0, stack.planes, rng)));
    const Eigen::Vector3d edges(stack.plane.resolution, stack.plane.resolution, stack.height);
    Eigen::Vector3d low = at.cast<double>().cwiseProduct(edges);
    low += Eigen::Vector3d(ground.frame.T_map_grid.x, ground.frame.T_map_grid.y, stack.first_z);
    const Eigen::AlignedBox3d box(low, Eigen::Vector3d(low + edges));
    double least = 1e9;
    for (std::size_t k = 0; k < voxels.size(); ++k) {
      const Eigen::Vector3d p = voxels.point(k);
      const GroundSurface* under = surface_near(ground, p.head<2>(), p.z());
      if (under != nullptr && std::abs(static_cast<double>(under->z) - p.z()) <= 0.12) continue;
      if (is_under(ground, stack, p, at.z())) continue;
      least = std::min(least, distance_to(box, p));
    }
    const double expected =
        least < 3.0 * kSigma ? 255.0 * std::exp(-0.5 * least * least / (kSigma * kSigma)) : 0.0;
    const auto byte = bytes[stack.grid().index(stack.stacked({at.x(), at.y()}, at.z()))];
    EXPECT_NEAR(byte, expected, 1.5) << at.transpose();
  }
}

/// A slab's underside is near to what low lidars hit on the slab.
TEST(StackedObstacles, OnAFloorItsUndersideIsNoObstacle) {
  Rng rng = substream(3, "stacked_obstacles");
  const test::Building building(rng, 0);
  const ElevationMap& ground = building.volume().atlas().ground();
  const StackFrame stack(ground, StackConfig{});
  const auto bytes = stack_obstacles(building.volume().voxels(), ground, stack, 0.15);
  const auto cell_at = [&](double x, double y) {
    return stack.plane.cell_of(stack.plane.T_map_grid.inverse() * Eigen::Vector2d(x, y));
  };
  const Eigen::Vector2i low = cell_at(6.5, 1.0);
  const Eigen::Vector2i high = cell_at(9.0, 5.0);
  const int floor = stack.plane_of(3.0);
  const auto most_in = [&](int plane) {
    int most = 0;
    for (int row = low.y(); row <= high.y(); ++row) {
      for (int column = low.x(); column <= high.x(); ++column) {
        most = std::max<int>(most, bytes[stack.grid().index(stack.stacked({column, row}, plane))]);
      }
    }
    return most;
  };
  EXPECT_EQ(most_in(floor), 0);
  EXPECT_EQ(most_in(floor + 1), 0);
  EXPECT_EQ(most_in(floor - 1), 255);  // Seen from the floor below.
}

TEST(StackedObstacles, BetweenPlanesThereIsNothing) {
  Rng rng = substream(2, "stacked_obstacles");
  const test::Building building(rng, 4);
  const ElevationMap& ground = building.volume().atlas().ground();
  const StackFrame stack(ground, StackConfig{});
  const auto bytes = stack_obstacles(building.volume().voxels(), ground, stack, 0.15);
  EXPECT_GE(stack.pitch - stack.plane.height, stack.reach);
  for (int plane = 0; plane < stack.planes; ++plane) {
    const std::size_t first = stack.grid().index(stack.stacked({0, stack.plane.height}, plane));
    const std::size_t end = stack.grid().index(stack.stacked({0, stack.pitch}, plane));
    for (std::size_t i = first; i < end; ++i) ASSERT_EQ(bytes[i], 0) << plane;
  }
}

}  // namespace
}  // namespace castaway::localization
