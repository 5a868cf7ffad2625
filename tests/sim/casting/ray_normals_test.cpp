#include "sim/casting/ray_normals.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

using Eigen::Vector3d;

RayPrimitive at(const RayShape& shape, const Vector3d& p_map, double yaw = 0.0) {
  RayPrimitive primitive{shape};
  primitive.T_map_shape = Eigen::Translation3d(p_map) * Eigen::AngleAxisd(yaw, Vector3d::UnitZ());
  return primitive;
}

void expect_normal(const RayPrimitive& primitive, const Vector3d& p_map, const Vector3d& expected) {
  EXPECT_LT((normal_at(primitive, p_map) - expected).norm(), 1e-9);
}

TEST(RayNormals, OfEachShapeByHand) {
  const RayPrimitive box = at(RayBox{{1.0, 0.5, 0.25}}, {3.0, 0.0, 0.0});
  expect_normal(box, {2.0, 0.4, 0.0}, -Vector3d::UnitX());
  expect_normal(box, {3.2, 0.5, 0.0}, Vector3d::UnitY());
  expect_normal(box, {3.2, 0.1, -0.25}, -Vector3d::UnitZ());
  const RayPrimitive cylinder = at(RayCylinder{0.5, 1.0}, {1.0, 1.0, 1.0});
  expect_normal(cylinder, {0.5, 1.0, 1.3}, -Vector3d::UnitX());
  expect_normal(cylinder, {1.1, 1.0, 2.0}, Vector3d::UnitZ());
  expect_normal(at(RaySphere{2.0}, {0.0, 0.0, 0.0}), {0.0, 2.0, 0.0}, Vector3d::UnitY());
  expect_normal(at(RayCapsule{0.5, 1.0}, {0.0, 0.0, 0.0}), {0.0, -0.5, 0.7}, -Vector3d::UnitY());
  expect_normal(at(RayCapsule{0.5, 1.0}, {0.0, 0.0, 0.0}), {0.0, 0.0, 1.5}, Vector3d::UnitZ());
}

TEST(RayNormals, TurnWithTheirShape) {
  const double yaw = std::numbers::pi / 6;
  const RayPrimitive box = at(RayBox{{1.0, 1.0, 1.0}}, {0.0, 0.0, 0.0}, yaw);
  expect_normal(box, {std::cos(yaw), std::sin(yaw), 0.0}, {std::cos(yaw), std::sin(yaw), 0.0});
}

TEST(RayNormals, CosineOfIncidenceOnATurnedWall) {
  const double yaw = std::numbers::pi / 3;
  const RayPrimitive wall = at(RayBox{{0.05, 4.0, 1.0}}, {2.0, 0.0, 0.0}, yaw);
  const Ray ray{Vector3d::Zero(), Vector3d::UnitX()};
  EXPECT_NEAR(incidence_cosine(wall, ray, intersect(wall, ray)), 0.5, 1e-12);
  const RayPrimitive triangle = at(RayTriangle{{2, -1, -1}, {2, 1, -1}, {2, 0, 1}}, {0, 0, 0});
  EXPECT_DOUBLE_EQ(incidence_cosine(triangle, ray, 2.0), 1.0);
}

TEST(RayNormals, CosineOfIncidenceOnAPersonsLeg) {
  UprightPart leg;
  leg.center = {2.0, 0.0};
  leg.half_size = {0.1, 0.1};
  MovingBody body;
  body.object = 77;
  body.parts[0] = leg;
  body.count = 1;
  const MovingScene scene({body});
  EXPECT_NEAR(incidence_cosine(scene, 77, {{0.0, 0.0, 0.5}, Vector3d::UnitX()}), 1.0, 1e-12);
  // Half the radius off the axis: the sine of the incidence is 0.5.
  EXPECT_NEAR(incidence_cosine(scene, 77, {{0.0, 0.05, 0.5}, Vector3d::UnitX()}), std::sqrt(0.75),
              1e-9);
  EXPECT_EQ(incidence_cosine(scene, 78, {{0.0, 0.0, 0.5}, Vector3d::UnitX()}), 1.0);
}

TEST(ExitDistance, IsWhereTheRayLeaves) {
  const Ray ray{Vector3d::Zero(), Vector3d::UnitX()};
  EXPECT_NEAR(exit_distance(at(RayBox{{0.05, 1.0, 1.0}}, {2.0, 0.0, 0.0}), ray, 1.95), 2.05, 2e-6);
  EXPECT_NEAR(exit_distance(at(RaySphere{0.5}, {2.0, 0.0, 0.0}), ray, 1.5), 2.5, 2e-6);
  const RayPrimitive triangle = at(RayTriangle{{2, -1, -1}, {2, 1, -1}, {2, 0, 1}}, {0, 0, 0});
  EXPECT_NEAR(exit_distance(triangle, ray, 2.0), 2.0, 2e-6);
}

}  // namespace
}  // namespace castaway::sim
