#include "sim/map/surface_samples.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

std::vector<Eigen::Vector3d> samples_of(const std::array<Eigen::Vector3d, 3>& corners,
                                        double spacing) {
  std::vector<Eigen::Vector3d> points;
  sample_triangle(corners, spacing, [&](const Eigen::Vector3d& p) { points.push_back(p); });
  return points;
}

/// [m] From a point to the nearest sample.
double to_nearest(const std::vector<Eigen::Vector3d>& samples, const Eigen::Vector3d& p) {
  double least = 1e9;
  for (const Eigen::Vector3d& sample : samples) least = std::min(least, (sample - p).norm());
  return least;
}

TEST(SampleTriangle, LeavesNoGapLargerThanTheSpacing) {
  const std::array<Eigen::Vector3d, 3> corners{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 2, 0.5),
                                               Eigen::Vector3d(-0.3, 1, 2)};
  const auto samples = samples_of(corners, 0.1);
  for (double s = 0.0; s <= 1.0; s += 0.05) {
    for (double t = 0.0; s + t <= 1.0; t += 0.05) {
      const Eigen::Vector3d p =
          corners[0] + s * (corners[1] - corners[0]) + t * (corners[2] - corners[0]);
      EXPECT_LT(to_nearest(samples, p), 0.1) << s << ' ' << t;
    }
  }
}

TEST(SampleTriangle, ALongNarrowTriangleTakesFewPoints) {
  const auto samples = samples_of(
      {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0.01, 0), Eigen::Vector3d(50, 0, 0)}, 0.05);
  EXPECT_NEAR(static_cast<double>(samples.size()), 500.0, 1.0);  // One row, half of the edge.
  for (const Eigen::Vector3d& p : samples) EXPECT_NEAR(p.y(), 0.0025, 0.003);
}

TEST(SampleTriangle, WithoutAreaThereIsNone) {
  EXPECT_TRUE(
      samples_of({Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(2, 2, 2)},
                 0.1)
          .empty());
}

WorldSpec box_world() {
  WorldSpec world;
  world.min_corner = {-1.0, -1.0};
  world.max_corner = {3.0, 1.0};
  WorldObject box;
  box.shape = BoxShape{{1.0, 1.0, 1.0}};
  box.T_map_object.translation() = Eigen::Vector3d(1.0, 0.0, 0.3);  // 0.2 m in the floor.
  world.objects.push_back(box);
  return world;
}

TEST(SampleSurfaces, CoversTheFloorAndTheObjectsAboveIt) {
  std::vector<Eigen::Vector3d> points;
  sample_surfaces(box_world(), 0.1,
                  [&](const Eigen::Vector3d& p, const Eigen::Vector3d&) { points.push_back(p); });
  const auto on_floor = std::ranges::count_if(points, [](const auto& p) { return p.z() == 0.0; });
  EXPECT_EQ(on_floor, 40 * 20 - 10 * 10);  // Not under the box.
  EXPECT_LT(to_nearest(points, {1.5, 0.2, 0.4}), 0.1);
  EXPECT_LT(to_nearest(points, {0.8, 0.2, 0.8}), 0.1);
  EXPECT_GT(to_nearest(points, {1.0, 0.0, 0.4}), 0.35);  // Inside.
  for (const Eigen::Vector3d& p : points) EXPECT_GE(p.z(), -1e-6);
}

TEST(SampleSurfaces, NormalsPointAwayFromTheObject) {
  sample_surfaces(box_world(), 0.1, [](const Eigen::Vector3d& p, const Eigen::Vector3d& normal) {
    EXPECT_NEAR(normal.norm(), 1.0, 1e-9);
    const Eigen::Vector3d centre(1.0, 0.0, p.z() == 0.0 ? -1.0 : 0.3);
    EXPECT_GT(normal.dot(p - centre), 0.0);
  });
}

TEST(SampleSurfaces, RoundObjectsAreCoveredWhereTheyAre) {
  const Eigen::Vector3d centre(1.0, 0.0, 0.6);
  for (const ObjectShape& shape :
       {ObjectShape(CylinderShape{0.3, 1.0}), ObjectShape(SphereShape{0.3})}) {
    WorldSpec world = box_world();
    world.objects[0].shape = shape;
    world.objects[0].T_map_object.translation() = centre;
    std::vector<Eigen::Vector3d> points;
    sample_surfaces(world, 0.05,
                    [&](const Eigen::Vector3d& p, const Eigen::Vector3d&) { points.push_back(p); });
    for (double angle = 0.0; angle < 6.3; angle += 0.1) {
      const Eigen::Vector3d out(0.3 * std::cos(angle), 0.3 * std::sin(angle), 0.0);
      EXPECT_LT(to_nearest(points, centre + out), 0.05) << angle;
    }
    for (const Eigen::Vector3d& p : points) {
      const double radius = (p - centre).head<2>().norm();
      if (std::abs(p.z() - centre.z()) < 0.01) {
        EXPECT_NEAR(radius, 0.3, 0.001);
      }
    }
  }
}

/// Number of points at the floor, with an object over a part of it.
std::ptrdiff_t floor_under(const ObjectShape& shape, double z) {
  WorldSpec world = box_world();
  world.objects[0].shape = shape;
  world.objects[0].T_map_object.translation().z() = z;
  std::ptrdiff_t count = 0;
  sample_surfaces(world, 0.1, [&](const Eigen::Vector3d& p, const Eigen::Vector3d&) {
    count += p.z() == 0.0 ? 1 : 0;
  });
  return count;
}

TEST(SampleSurfaces, TheFloorIsHiddenUnderARampAndNotUnderASlab) {
  EXPECT_EQ(floor_under(RampShape{{1.0, 1.0, 0.5}}, 0.25), 700);
  EXPECT_EQ(floor_under(BoxShape{{1.0, 1.0, 0.2}}, 2.0), 800);
}

TEST(SampleSurfaces, WhatIsNotOnTheMapHasNone) {
  WorldSpec world = box_world();
  world.objects[0].in_map = false;
  std::size_t count = 0;
  sample_surfaces(world, 0.1, [&](const Eigen::Vector3d&, const Eigen::Vector3d&) { ++count; });
  EXPECT_EQ(count, 800U);
  world.max_corner = world.min_corner;
  EXPECT_THROW(sample_surfaces(world, 0.1, [](const Eigen::Vector3d&, const Eigen::Vector3d&) {}),
               std::invalid_argument);
}

}  // namespace
}  // namespace castaway::sim
