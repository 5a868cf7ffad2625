#include "sim/casting/ray_shapes.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

const Ray kAlongX{{-5.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};

Ray shifted(double y, double z) { return {{-5.0, y, z}, {1.0, 0.0, 0.0}}; }

TEST(RayShapes, BoxByHand) {
  const RayShape box = RayBox{{1.0, 2.0, 3.0}};
  EXPECT_DOUBLE_EQ(intersect(box, kAlongX), 4.0);
  EXPECT_DOUBLE_EQ(intersect(box, shifted(1.99, 2.99)), 4.0);
  EXPECT_EQ(intersect(box, shifted(2.01, 0.0)), kNoHit);
  EXPECT_EQ(intersect(box, shifted(0.0, -3.01)), kNoHit);
  const double diagonal = std::sqrt(0.5);
  EXPECT_DOUBLE_EQ(intersect(box, Ray{{-3.0, -2.5, 0.0}, {diagonal, diagonal, 0.0}}),
                   2.0 / diagonal);
}

TEST(RayShapes, SphereByHand) {
  EXPECT_DOUBLE_EQ(intersect(RaySphere{2.0}, kAlongX), 3.0);
  EXPECT_DOUBLE_EQ(intersect(RaySphere{5.0}, Ray{{-9.0, 3.0, 0.0}, {1.0, 0.0, 0.0}}), 5.0);
  EXPECT_EQ(intersect(RaySphere{2.0}, shifted(2.01, 0.0)), kNoHit);
}

TEST(RayShapes, CylinderByHand) {
  const RayShape cylinder = RayCylinder{2.0, 1.0};
  EXPECT_DOUBLE_EQ(intersect(cylinder, kAlongX), 3.0);
  EXPECT_EQ(intersect(cylinder, shifted(0.0, 1.01)), kNoHit);
  EXPECT_DOUBLE_EQ(intersect(cylinder, Ray{{0.5, 0.5, 4.0}, {0.0, 0.0, -1.0}}), 3.0);
  EXPECT_EQ(intersect(cylinder, Ray{{1.5, 1.5, 4.0}, {0.0, 0.0, -1.0}}), kNoHit);
}

TEST(RayShapes, CapsuleByHand) {
  const RayShape capsule = RayCapsule{1.0, 2.0};
  EXPECT_DOUBLE_EQ(intersect(capsule, kAlongX), 4.0);
  EXPECT_DOUBLE_EQ(intersect(capsule, Ray{{0.0, 0.0, 9.0}, {0.0, 0.0, -1.0}}), 6.0);
  EXPECT_DOUBLE_EQ(intersect(capsule, shifted(0.0, 2.6)), 5.0 - 0.8);
  EXPECT_EQ(intersect(capsule, shifted(0.0, 3.01)), kNoHit);
}

TEST(RayShapes, TriangleByHandFromBothSides) {
  const RayShape triangle = RayTriangle{{0, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  EXPECT_DOUBLE_EQ(intersect(triangle, shifted(0.5, 0.5)), 5.0);
  EXPECT_DOUBLE_EQ(intersect(triangle, Ray{{5.0, 0.5, 0.5}, {-1.0, 0.0, 0.0}}), 5.0);
  EXPECT_EQ(intersect(triangle, shifted(1.1, 1.1)), kNoHit);
}

TEST(RayShapes, NothingBehindTheOriginAndNoWayFromInside) {
  for (const RayShape& shape : {RayShape(RayBox{{1, 1, 1}}), RayShape(RaySphere{1}),
                                RayShape(RayCylinder{1, 1}), RayShape(RayCapsule{1, 1})}) {
    EXPECT_EQ(intersect(shape, Ray{{3.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}), kNoHit);
    EXPECT_EQ(intersect(shape, Ray{{0.1, 0.2, 0.3}, {1.0, 0.0, 0.0}}), 0.0);
  }
}

TEST(RayShapes, PlacedShapesAreHitWhereTheyStand) {
  RayPrimitive box{RayBox{{1.0, 0.5, 1.0}}, Eigen::Isometry3d::Identity(), 3};
  box.T_map_shape = Eigen::Translation3d(4.0, 2.0, 0.0) *
                    Eigen::AngleAxisd(1.5707963267948966, Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(intersect(box, Ray{{0.0, 2.9, 0.0}, {1.0, 0.0, 0.0}}), 3.5, 1e-12);
  EXPECT_TRUE(bounds(box).min().isApprox(Eigen::Vector3d(3.5, 1.0, -1.0), 1e-12));
}

TEST(RayShapes, FarSpheresKeepTheirPrecision) {
  const double distance = intersect(RaySphere{0.5}, Ray{{-1e4, 0.3, 0.0}, {1.0, 0.0, 0.0}});
  EXPECT_NEAR(distance, 1e4 - 0.4, 1e-9);
}

}  // namespace
}  // namespace castaway::sim
