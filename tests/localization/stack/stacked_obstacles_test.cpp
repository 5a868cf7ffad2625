#include "localization/stack/stacked_obstacles.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/localization/map3d/building.hpp"

namespace castaway::localization {
namespace {

/// Distance from a point to a box. [m]
double distance_to(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& p) {
  return box.exteriorDistance(p);
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
      least = std::min(least, distance_to(box, p));
    }
    const double expected =
        least < 3.0 * kSigma ? 255.0 * std::exp(-0.5 * least * least / (kSigma * kSigma)) : 0.0;
    const auto byte = bytes[stack.grid().index(stack.stacked({at.x(), at.y()}, at.z()))];
    EXPECT_NEAR(byte, expected, 1.5) << at.transpose();
  }
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
