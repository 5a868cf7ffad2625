#include "sim/world/footprint.hpp"

#include <gtest/gtest.h>

#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

constexpr double kQuarter = 1.5707963267948966;

TEST(Footprint, IsTheBoxSeenFromAbove) {
  const ConvexOutline outline = footprint(box_on_floor("b", {2.0, 1.0, 0.5}, {3.0, 1.0}, kQuarter));
  EXPECT_EQ(outline.points.size(), 4U);
  const Eigen::AlignedBox2d box = bounds(outline);
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector2d(2.5, 0.0), 1e-9));
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector2d(3.5, 2.0), 1e-9));
}

TEST(Footprint, HoldsRoundShapes) {
  WorldObject ball;
  ball.shape = SphereShape{0.5};
  ball.T_map_object = Eigen::Translation3d(1.0, 1.0, 0.5);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector2d rim =
        Eigen::Vector2d(1.0, 1.0) + Eigen::Rotation2Dd(0.1 * i) * Eigen::Vector2d(0.4999, 0.0);
    EXPECT_EQ(distance(footprint(ball), rim), 0.0);
  }
  EXPECT_TRUE(bounds(ball).isApprox(
      Eigen::AlignedBox3d(Eigen::Vector3d(0.5, 0.5, 0.0), Eigen::Vector3d(1.5, 1.5, 1.0)), 0.02));
}

TEST(Footprint, TellsOverlapsFromNeighbours) {
  const auto at = [](double x, double y, double yaw) {
    return footprint(box_on_floor("b", {1.0, 1.0, 1.0}, {x, y}, yaw));
  };
  EXPECT_TRUE(overlap(at(0, 0, 0), at(0.99, 0, 0)));
  EXPECT_FALSE(overlap(at(0, 0, 0), at(1.01, 0, 0)));
  // Corner to corner: the bounding boxes overlap, the squares do not.
  EXPECT_FALSE(overlap(at(0, 0, 0.5 * kQuarter), at(0.75, 0.75, 0.5 * kQuarter)));
  EXPECT_TRUE(overlap(at(0, 0, 0.5 * kQuarter), at(0.65, 0.65, 0.5 * kQuarter)));
}

TEST(Footprint, MeasuresDistances) {
  const ConvexOutline square = footprint(box_on_floor("b", {2.0, 2.0, 1.0}, {0.0, 0.0}));
  EXPECT_DOUBLE_EQ(distance(square, {0.5, 0.5}), 0.0);
  EXPECT_DOUBLE_EQ(distance(square, {3.0, 0.0}), 2.0);
  EXPECT_DOUBLE_EQ(distance(square, {4.0, 5.0}), 5.0);
}

TEST(Footprint, MovesAboutAPoint) {
  const ConvexOutline square = footprint(box_on_floor("b", {2.0, 1.0, 1.0}, {1.0, 0.0}));
  const Eigen::AlignedBox2d box =
      bounds(transform_outline(square, {0.0, 0.0}, kQuarter, {5.0, 0.0}));
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector2d(4.5, 0.0), 1e-9));
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector2d(5.5, 2.0), 1e-9));
}

}  // namespace
}  // namespace castaway::sim
